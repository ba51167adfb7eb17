// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/ObstacleMeeting.h"

#include <algorithm>
#include <array>
#include <utility>

namespace simulation
{

void ObstacleMeeting::meet(std::shared_ptr<const ObstacleMap> obstacles)
{
    _map = std::move(obstacles);
    _fast.clear();
    _giving.clear();
    forget();
}

void ObstacleMeeting::forget()
{
    _broken.clear();
    _impacts.clear();
    _numbers.clear();
}

void ObstacleMeeting::look(const glm::dvec2& low, const glm::dvec2& high)
{
    _fast.clear();
    _giving.clear();
    if (!_map) return;
    _map->near(low, high, _near);
    for (const std::uint32_t number : _near)
        if (standsFast(_map->at(number).kind))
            _fast.push_back(number);
        else if (!_broken.contains(number))
            _giving.push_back(number);
}

void ObstacleMeeting::note(const ObstacleTouch& touch)
{
    for (std::size_t i = _impacts.size(); i-- > 0 && touch.timeS - _impacts[i].lastS < kOneImpactS;)
        if (_numbers[i] == touch.number)
        {
            _impacts[i].lastS = touch.timeS;
            _impacts[i].closingMps = std::max(_impacts[i].closingMps, touch.closingMps);
            _impacts[i].hasGiven = _impacts[i].hasGiven || touch.hasGiven;
            if (!touch.damage.empty())
                _impacts[i].damage += (_impacts[i].damage.empty() ? "" : ", ") + touch.damage;
            return;
        }
    if (touch.closingMps < kLeastToldMps || _impacts.size() >= kMostImpacts) return;
    const double speedMps = glm::length(touch.velocity);
    _impacts.push_back({touch.timeS, touch.timeS, speedMps, touch.closingMps, touch.place,
                        speedMps > 1e-9 ? touch.velocity / speedMps : glm::dvec3(0.0), kindOf(touch.number),
                        nameOf(touch.number), touch.hasGiven, touch.damage});
    _numbers.push_back(touch.number);
}

ObstacleKind ObstacleMeeting::kindOf(std::uint32_t number) const
{
    if (number < kMovers) return _map->at(number).kind;
    if (number >= kGround) return number == kGround ? ObstacleKind::ground : ObstacleKind::water;
    for (const MovingObstacle& mover : _movers)
        if (numberOf(mover.number) == number) return mover.box.kind;
    return ObstacleKind::thing;
}

std::string ObstacleMeeting::nameOf(std::uint32_t number) const
{
    if (number < kMovers) return std::string(_map->nameOf(number));
    for (const MovingObstacle& mover : _movers)
        if (numberOf(mover.number) == number) return mover.name;
    return {};
}

std::string_view ObstacleMeeting::reason(std::uint32_t number) const
{
    static constexpr std::array<std::string_view, static_cast<std::size_t>(ObstacleKind::count)> kReasons{
        "it hit a house",
        "it hit a wall",
        "it hit a fence",
        "it hit a guard rail",
        "it hit a barrier",
        "it hit the rail of a bridge",
        "it hit the wall of a tunnel",
        "it hit a pillar",
        "it hit a mast",
        "it hit a post",
        "it hit a marker",
        "it hit a tree",
        "it hit a hedge",
        "it hit a vehicle",
        "it hit a thing that stands there",
        "it hit a person",
        "it hit the ground",
        "it came down on water"};
    return kReasons[static_cast<std::size_t>(kindOf(number))];
}

} // namespace simulation
