// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/check/JunctionCheck.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <osgRoads/core/network/LaneType.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/query/Stations.h>

namespace worldmaking
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgRoads::core::Road;
using osgRoads::core::RoadPosition;

constexpr double kJunctionEachM = 1.0, kInsideM = 0.05;

/// The part of a cross-section where cars drive; empty where `rightT` is not below `leftT`.
osgRoads::core::RoadExtent carsAt(const Road& road, double s)
{
    osgRoads::core::RoadExtent extent{1e9, -1e9};
    const auto* section = osgRoads::core::sectionAt(road, s);
    for (const int sign : {-1, 1})
        if (section)
            osgRoads::core::forLanesOutwards(road, *section, sign, s,
                                             [&](const osgRoads::core::LaneSpan& span)
                                             {
                                                 if (!osgRoads::core::isForCars(span.lane->type)) return true;
                                                 for (const double t : {span.innerT, span.outerT})
                                                     extent.rightT = std::min(extent.rightT, t),
                                                     extent.leftT = std::max(extent.leftT, t);
                                                 return true;
                                             });
    return extent;
}

bool liesOnGround(const Road& road, double s)
{
    return !osgRoads::core::structureAt(road, s);
}

/// Looks at one connecting road.
class JunctionLooker
{
public:
    JunctionLooker(const PlacedNetwork& roads, int index)
        : _roads(roads),
          _index(index),
          _road(roads.road(index)),
          _step{JunctionFlaw::step, index},
          _steep{JunctionFlaw::steep, index}
    {
    }

    void look(std::vector<JunctionFault>& faults)
    {
        for (const double s : osgRoads::core::evenStations(_road.length, kJunctionEachM))
        {
            const auto lanes = carsAt(_road, s);
            if (lanes.leftT - lanes.rightT < 4.0 * kInsideM || !liesOnGround(_road, s)) continue;
            for (const double t :
                 {lanes.rightT + kInsideM, 0.5 * (lanes.rightT + lanes.leftT), lanes.leftT - kInsideM})
                lookForSteps(s, t);
            lookForLean(s, lanes);
        }
        if (_step.by > kMostJunctionStepM) faults.push_back(_step);
        if (_steep.by > kMostJunctionLean) faults.push_back(_steep);
    }

private:
    void lookForSteps(double s, double t)
    {
        const glm::dvec3 place = _roads.surfacePoint(_index, s, t);
        for (const auto& match : _roads.locator().within(glm::dvec2(_roads.toInertial(place)), 0.0))
        {
            const RoadPosition& at = match.position;
            const Road& other = _roads.road(at.road);
            if (at.road == _index || !liesOnGround(other, at.s)) continue;
            const auto lanes = carsAt(other, at.s);
            if (at.t < lanes.rightT + kInsideM || at.t > lanes.leftT - kInsideM) continue;
            const double byM = std::fabs(_roads.surfacePoint(at.road, at.s, at.t).z - place.z);
            if (byM > kOtherLevelM || byM <= _step.by) continue;
            _step.by = byM, _step.other = at.road, _step.sM = s, _step.place = place;
        }
    }

    void lookForLean(double s, const osgRoads::core::RoadExtent& lanes)
    {
        const double t = 0.5 * (lanes.rightT + lanes.leftT);
        const double fromS = std::max(0.0, s - 0.5), toS = std::min(_road.length, s + 0.5);
        const auto rise = [](const glm::dvec3& from, const glm::dvec3& to)
        { return (to.z - from.z) / std::max(1e-3, glm::distance(glm::dvec2(from), glm::dvec2(to))); };
        const double along = rise(_roads.surfacePoint(_index, fromS, t), _roads.surfacePoint(_index, toS, t)),
                     across = rise(_roads.surfacePoint(_index, s, lanes.rightT + kInsideM),
                                   _roads.surfacePoint(_index, s, lanes.leftT - kInsideM));
        const double lean = std::hypot(along, across);
        if (lean <= _steep.by) return;
        _steep.by = lean, _steep.sM = s, _steep.place = _roads.surfacePoint(_index, s, t);
    }

    const PlacedNetwork& _roads;
    int _index;
    const Road& _road;
    JunctionFault _step, _steep;
};

} // namespace

std::vector<JunctionFault> junctionFaults(const PlacedNetwork& roads)
{
    std::vector<JunctionFault> faults;
    for (int i = 0; i < static_cast<int>(roads.network().roads.size()); ++i)
        if (roads.road(i).isUsable && !roads.road(i).junctionId.empty())
            JunctionLooker(roads, i).look(faults);
    return faults;
}

} // namespace worldmaking
