// SPDX-License-Identifier: Apache-2.0
#include "simulation/contact/ObstacleMap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace simulation
{

namespace
{

constexpr double kFarthestM = 1e7; ///< from the origin, within what cells have keys for

std::int64_t cellAt(double metres)
{
    return static_cast<std::int64_t>(
        std::floor(std::clamp(metres, -kFarthestM, kFarthestM) / ObstacleMap::kCellM));
}

/// Cells of one column follow each other.
std::uint64_t keyOf(std::int64_t column, std::int64_t row)
{
    constexpr std::int64_t kHalf = std::int64_t(1) << 31;
    return static_cast<std::uint64_t>(column + kHalf) << 32 | static_cast<std::uint64_t>(row + kHalf);
}

bool isUsable(const Obstacle& obstacle)
{
    const glm::dvec2 sum = obstacle.middle + obstacle.halfM + obstacle.along;
    return std::isfinite(sum.x + sum.y + obstacle.lowM + obstacle.highM) && obstacle.halfM.x > 0.0 &&
           (obstacle.isRound || obstacle.halfM.y > 0.0) && obstacle.highM > obstacle.lowM;
}

} // namespace

void ObstacleList::add(Obstacle obstacle, std::string_view name)
{
    if (!isUsable(obstacle)) return;
    obstacle.halfM = glm::min(obstacle.halfM, glm::dvec2(ObstacleMap::kLargestM));
    auto found = std::find(_names.begin(), _names.end(), name);
    if (found == _names.end() && _names.size() < std::numeric_limits<std::uint16_t>::max())
        found = _names.insert(found, std::string(name));
    obstacle.name =
        found == _names.end() ? std::uint16_t(0) : static_cast<std::uint16_t>(found - _names.begin());
    _obstacles.push_back(obstacle);
}

void ObstacleList::add(const ObstacleList& more)
{
    _obstacles.reserve(_obstacles.size() + more._obstacles.size());
    for (const Obstacle& obstacle : more._obstacles)
        add(obstacle, more._names[obstacle.name]);
}

ObstacleMap::ObstacleMap(ObstacleList list) : _list(std::move(list))
{
    for (std::uint32_t number = 0; number < _list.obstacles().size(); ++number)
    {
        const Obstacle& obstacle = at(number);
        const glm::dvec2 low = obstacle.middle - obstacle.reachM(),
                         high = obstacle.middle + obstacle.reachM();
        for (std::int64_t column = cellAt(low.x); column <= cellAt(high.x); ++column)
            for (std::int64_t row = cellAt(low.y); row <= cellAt(high.y); ++row)
                _entries.push_back({keyOf(column, row), number});
    }
    std::sort(_entries.begin(), _entries.end(),
              [](const Entry& a, const Entry& b)
              { return std::tie(a.cell, a.number) < std::tie(b.cell, b.number); });
}

void ObstacleMap::near(const glm::dvec2& low, const glm::dvec2& high, std::vector<std::uint32_t>& found) const
{
    found.clear();
    for (std::int64_t column = cellAt(low.x); column <= cellAt(high.x); ++column)
    {
        const std::uint64_t last = keyOf(column, cellAt(high.y));
        auto entry = std::lower_bound(_entries.begin(), _entries.end(), keyOf(column, cellAt(low.y)),
                                      [](const Entry& e, std::uint64_t cell) { return e.cell < cell; });
        for (; entry != _entries.end() && entry->cell <= last; ++entry)
        {
            const Obstacle& obstacle = at(entry->number);
            const glm::dvec2 reach = obstacle.reachM();
            if (glm::all(glm::lessThanEqual(low, obstacle.middle + reach)) &&
                glm::all(glm::lessThanEqual(obstacle.middle - reach, high)))
                found.push_back(entry->number);
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
}

ObstacleList ObstacleMap::moved(const glm::dvec2& by) const
{
    ObstacleList list;
    for (Obstacle obstacle : _list.obstacles())
    {
        obstacle.middle += by;
        list.add(obstacle, _list.names()[obstacle.name]);
    }
    return list;
}

std::string_view ObstacleMap::nameOf(std::uint32_t number) const
{
    const Obstacle& obstacle = at(number);
    const std::string& name = _list.names()[obstacle.name];
    return name.empty() ? factsOf(obstacle.kind).name : std::string_view(name);
}

} // namespace simulation
