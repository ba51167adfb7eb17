// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/PlacementCheck.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <foundation/NearestOnSegment.h>

#include "scenery/placement/Footing.h"
#include "scenery/placement/TakenDiscs.h"

namespace scenery
{

namespace
{

/// Between the places that placement looks at the ground may go a little beyond.
constexpr double kSlackM = 0.1;
constexpr double kRounding = 1e-9;

double toLine(glm::dvec2 place, const Corridor& corridor)
{
    double least = 1e30;
    for (std::size_t i = 0; i < corridor.line.size(); ++i)
    {
        const glm::dvec2 from = corridor.line[i],
                         to = corridor.line[std::min(i + 1, corridor.line.size() - 1)];
        least = std::min(least,
                         glm::length(place - from - foundation::nearestShare(place, from, to) * (to - from)));
    }
    return least - corridor.halfWidthM;
}

class Check
{
public:
    Check(const PlacedScenery& placed, const SceneryDescription& description,
          std::span<const Measures> measures, const Ground& ground)
        : _placed(placed), _description(description), _measures(measures), _ground(ground)
    {
    }

    std::string ofRooms() const
    {
        std::vector<std::pair<double, std::uint32_t>> byEast;
        for (std::uint32_t i = 0; i < _placed.placements.size(); ++i)
            byEast.emplace_back(_placed.placements[i].position.x, i);
        std::sort(byEast.begin(), byEast.end());
        double widest = 0.0;
        for (const Placement& p : _placed.placements)
            widest = std::max(widest, discOf(p).roomM);
        for (std::size_t a = 0; a < byEast.size(); ++a)
            for (std::size_t b = a + 1; b < byEast.size(); ++b)
            {
                const Disc first = discOf(_placed.placements[byEast[a].second]),
                           second = discOf(_placed.placements[byEast[b].second]);
                if (byEast[b].first - byEast[a].first > first.roomM + widest) break;
                if (glm::length(first.centre - second.centre) < leastDistanceM(first, second) - kRounding)
                    return nameOf(byEast[a].second) + " and " + nameOf(byEast[b].second) + " overlap";
            }
        return {};
    }

    std::string ofRules(std::uint32_t i, const Ways& ways) const
    {
        const Placement& p = _placed.placements[i];
        const SceneryField& field = _description.fields[p.field];
        const Where& where = field.where;
        const glm::dvec2 place(p.position);
        const double room = _measures[p.object].radiusM * p.scale;
        if (p.scale < field.leastScale || p.scale > field.mostScale) return nameOf(i) + " has a wrong scale";
        for (const auto* const corridors : {&ways.keepClear, &_placed.streets})
            for (const Corridor& corridor : *corridors)
                if (toLine(place, corridor) < room - kSlackM) return nameOf(i) + " stands in a way";
        if (where.circle && glm::length(place - where.circle->centreM) > where.circle->radiusM + kRounding)
            return nameOf(i) + " is outside its circle";
        const double elevation = _ground.elevationOf(place.x, place.y, p.position.z);
        if (!where.heightM.contains(elevation)) return nameOf(i) + " is too high or too low";
        if (!where.inWater && elevation <= _ground.seaLevelM) return nameOf(i) + " is in the water";
        if (!where.covers.empty() && _ground.cover &&
            std::find(where.covers.begin(), where.covers.end(), _ground.cover(place.x, place.y)) ==
                where.covers.end())
            return nameOf(i) + " stands on the wrong cover";
        return {};
    }

    std::string ofFooting(std::uint32_t i) const
    {
        const Placement& p = _placed.placements[i];
        Measures finer = _measures[p.object];
        const double most = finer.stance == Stance::upright ? kMostBuriedM : kMostSunkM;
        const double reach = finer.foundationM * p.scale;
        for (const glm::dvec2& at : basePlaces(finer, 2.0 * p.scale)) // twice the size: twice as many places
        {
            const glm::dvec3 rim = p.position + p.axes * glm::dvec3(0.5 * at, 0.0);
            const auto height = _ground.heightM(rim);
            if (!height) return nameOf(i) + " stands beyond the ground";
            if (*height < rim.z - reach - kSlackM) return nameOf(i) + " floats";
            if (*height > rim.z + most * p.scale + kSlackM) return nameOf(i) + " is buried";
        }
        return {};
    }

private:
    Disc discOf(const Placement& p) const
    {
        const SceneryField& field = _description.fields[p.field];
        const double room = _measures[p.object].radiusM * p.scale + 0.5 * field.spacingM;
        return {glm::dvec2(p.position), room,
                room * (_measures[p.object].isCrowned ? 1.0 - field.crowding : 1.0)};
    }
    std::string nameOf(std::uint32_t i) const
    {
        return _description.fields[_placed.placements[i].field].name + " " + std::to_string(i);
    }

    const PlacedScenery& _placed;
    const SceneryDescription& _description;
    std::span<const Measures> _measures;
    const Ground& _ground;
};

} // namespace

std::string defectOf(const PlacedScenery& placed, const SceneryDescription& description,
                     std::span<const Measures> measures, const Ground& ground, const Ways& ways)
{
    const Check check(placed, description, measures, ground);
    if (std::string defect = check.ofRooms(); !defect.empty()) return defect;
    for (std::uint32_t i = 0; i < placed.placements.size(); ++i)
    {
        if (std::string defect = check.ofRules(i, ways); !defect.empty()) return defect;
        if (std::string defect = check.ofFooting(i); !defect.empty()) return defect;
    }
    return {};
}

} // namespace scenery
