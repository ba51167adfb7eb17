// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/RoadWalk.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <foundation/Angle.h>

#include <osgRoads/core/query/LaneSpan.h>

namespace simulation
{
namespace
{

using osgRoads::core::Lane;
using osgRoads::core::Road;

constexpr int kMostSections = 1000; ///< crossed in one step
constexpr double kPi = std::numbers::pi;

/// Moves within the lane section. Returns the metres that are left beyond its border.
double walkSection(const RoadScene& roads, RoadPlace& place, double distanceM, bool towardsEnd)
{
    const Road& road = roads.roadAt(place);
    const int index = std::max(osgRoads::core::lastStartingBy(road.sections, place.s), 0);
    const auto& section = road.sections[static_cast<std::size_t>(index)];
    // Where s falls, the section that ends at this s is the one to leave.
    const bool isAtStart = !towardsEnd && place.s <= section.s && index > 0;
    const double border = towardsEnd ? section.end : isAtStart ? place.s : section.s;
    const double perMetre = 1.0 / std::max(1.0 - place.curvature * place.t, 0.05);
    const double wanted = distanceM * perMetre;
    const double room = std::fabs(border - place.s);
    const double moved = std::min(wanted, room);
    place.s += towardsEnd ? moved : -moved;
    return wanted > room ? (wanted - room) / perMetre : 0.0;
}

/// Goes from one lane section to the next of the same road. False: this is the road's end.
bool enterSection(const RoadScene& roads, RoadPlace& place, bool towardsEnd)
{
    const Road& road = roads.roadAt(place);
    const auto borderAt = [&](double s) { return std::fabs(s - place.s) < 1e-9; };
    for (std::size_t i = 0; i + 1 < road.sections.size(); ++i)
    {
        if (!borderAt(road.sections[i].end)) continue;
        const auto& from = road.sections[towardsEnd ? i : i + 1];
        const Lane* const lane = from.lane(place.lane);
        if (lane && place.lane != 0)
        {
            const std::vector<int>& links = towardsEnd ? lane->successors : lane->predecessors;
            if (!links.empty()) place.lane = links.front();
        }
        // Just inside: on the border itself the section that begins there would be taken.
        place.s += towardsEnd ? 1e-9 : -1e-9;
        return true;
    }
    return false;
}

/// Of several roads the one on the route, else one by chance, or the one on which the heading changes least.
const RoadStep* chosen(const RoadScene& roads, const std::vector<RoadStep>& steps, const RoadPlace& place,
                       const RoadWay& way, RandomDraw* turns)
{
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
        if (way[i] == place.road)
            for (const RoadStep& step : steps)
                if (step.road == way[i + 1]) return &step;
    if (turns && !steps.empty()) return &steps[turns->index(std::vector<double>(steps.size(), 1.0))];
    const RoadStep* best = nullptr;
    double least = 10.0;
    for (const RoadStep& step : steps)
    {
        const Road& road = roads.network().roads[static_cast<std::size_t>(step.road)];
        const double turn = std::fabs(foundation::wrappedRad(road.referenceLine.at(road.length).headingRad -
                                                             road.referenceLine.at(0.0).headingRad));
        if (turn >= least) continue;
        least = turn;
        best = &step;
    }
    return best;
}

/// Goes from a road to the one that follows. False: none does.
bool enterRoad(const RoadScene& roads, RoadPlace& place, bool towardsEnd, const RoadWay& way,
               RandomDraw* turns)
{
    const auto steps = stepsFrom(roads.network(), place.road, towardsEnd, place.lane);
    const RoadStep* const step = chosen(roads, steps, place, way, turns);
    if (!step) return false;
    const bool isTurned = step->entersAtStart != towardsEnd;
    place.road = step->road;
    place.lane = step->lane;
    place.s = step->entersAtStart ? 0.0 : roads.roadAt(place).length;
    if (isTurned)
    {
        place.laneOffsetM = -place.laneOffsetM;
        place.relativeHeadingRad = foundation::wrappedRad(place.relativeHeadingRad + kPi);
    }
    return true;
}

/// A lane whose width has shrunk to nothing is left to the one inside, as in esmini.
void leaveEndedLane(const RoadScene& roads, RoadPlace& place)
{
    constexpr double kNoWidthM = 1e-6;
    const int inwards = place.lane > 0 ? -1 : 1;
    for (; std::abs(place.lane) > 1; place.lane += inwards)
    {
        const auto span = osgRoads::core::laneSpan(roads.roadAt(place), place.lane, place.s);
        if (!span || span->width() > kNoWidthM) return;
    }
}

} // namespace

bool walk(const RoadScene& roads, RoadPlace& place, double distanceM, const RoadWay& way, RandomDraw* turns)
{
    double rest = std::fabs(distanceM);
    bool arrives = true;
    for (int crossed = 0; crossed < kMostSections; ++crossed)
    {
        const bool towardsEnd = looksForward(place) == (distanceM >= 0.0);
        rest = walkSection(roads, place, rest, towardsEnd);
        if (rest <= 0.0) break;
        if (enterSection(roads, place, towardsEnd)) continue;
        if (!enterRoad(roads, place, towardsEnd, way, turns))
        {
            arrives = false;
            break;
        }
        roads.putOnLane(place, place.lane, place.laneOffsetM);
    }
    leaveEndedLane(roads, place);
    if (!roads.putOnLane(place, place.lane, place.laneOffsetM)) roads.takeNearestLane(place);
    return arrives;
}

std::vector<RoadPlace> placesAlong(const RoadScene& roads, const JunctionLane& lane, double stepM)
{
    constexpr double kBeyondM = 10.0;
    RoadPlace place;
    place.road = lane.road;
    const double lengthM = roads.roadAt(place).length;
    place.s = lane.isForward ? 0.0 : lengthM;
    if (!roads.putOnLane(place, lane.lane, 0.0)) return {};
    place.relativeHeadingRad = lane.isForward ? 0.0 : kPi;
    std::vector<RoadPlace> places;
    for (double doneM = 0.0; place.road == lane.road && doneM < 2.0 * lengthM + kBeyondM; doneM += stepM)
    {
        places.push_back(place);
        if (!walk(roads, place, stepM, {})) break;
    }
    return places;
}

} // namespace simulation
