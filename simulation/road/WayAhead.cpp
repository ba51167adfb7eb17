// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/WayAhead.h"

#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

#include "simulation/road/SpeedLimit.h"
#include "simulation/road/StopSignals.h"

namespace simulation
{
namespace
{

constexpr double kStepM = 1.0, kSameM = 0.05;

/// Adds the stops of a piece of a road; `atM`: of its begin along the way.
void addStops(const RoadScene& roads, const RoadPlace& place, double fromM, double toM, double atM,
              std::vector<AheadStop>& stops)
{
    for (const RoadStop& stop : stopsBetween(roads.network(), place.road, place.lane, fromM, toM))
        if (stop.sM != toM) // the next piece begins there
            stops.push_back({atM + std::fabs(stop.sM - fromM), stop.signal});
}

double lengthOf(const RoadScene& roads, const RoadPlace& place)
{
    return roads.roadAt(place).length;
}

} // namespace

WayAhead wayAlongLane(const RoadScene& roads, RoadPlace place, const RoadWay& way,
                      std::optional<RandomDraw> turns, double lengthM)
{
    WayAhead ahead;
    place.relativeHeadingRad = looksForward(place) ? 0.0 : std::numbers::pi;
    ahead.points.push_back({roads.poseAt(place).position, speedLimitAt(roads, place)});
    double alongM = 0.0;
    for (bool goesOn = true; goesOn && alongM < lengthM;)
    {
        const RoadPlace before = place;
        goesOn = walk(roads, place, kStepM, way, turns ? &*turns : nullptr);
        const glm::dvec3 here = roads.poseAt(place).position;
        const double stepM = glm::distance(here, ahead.points.back().place);
        if (before.road == place.road && looksForward(before) == looksForward(place))
            addStops(roads, place, before.s, place.s, alongM, ahead.stops);
        else
        {
            const double endM = looksForward(before) ? lengthOf(roads, before) : 0.0;
            addStops(roads, before, before.s, endM, alongM, ahead.stops);
            const double startM = looksForward(place) ? 0.0 : lengthOf(roads, place);
            addStops(roads, place, startM, place.s, alongM + std::fabs(endM - before.s), ahead.stops);
        }
        if (stepM < kSameM) continue;
        alongM += stepM;
        ahead.points.push_back({here, speedLimitAt(roads, place)});
    }
    return ahead;
}

} // namespace simulation
