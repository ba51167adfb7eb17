// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/LaneMeetings.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/common.hpp>

#include <osgRoads/core/query/LaneSpan.h>

#include "simulation/road/RoadWalk.h"

namespace simulation
{
namespace
{

using osgRoads::core::Lane;
using osgRoads::core::LaneDirection;
using MetRoad = osgRoads::core::Road;

constexpr double kMetStepM = 1.0;
constexpr double kMetMiddleM = 1.62, kMetHalfLengthM = 2.9, kMetHalfWidthM = 1.02; ///< of a van

/// The lane of a road's begin, in the direction of driving, that goes on as a lane at an s.
int laneWhereEntered(const MetRoad& road, int lane, double s, bool isForward)
{
    int section = osgRoads::core::lastStartingBy(road.sections, s);
    const int step = isForward ? -1 : 1, count = static_cast<int>(road.sections.size());
    for (section = std::max(section, 0); section + step >= 0 && section + step < count; section += step)
    {
        const Lane* const here = road.sections[static_cast<std::size_t>(section)].lane(lane);
        if (!here) break;
        const auto& links = isForward ? here->predecessors : here->successors;
        if (!links.empty()) lane = links.front();
    }
    return lane;
}

/// The lanes for cars that can be entered at an end of a road.
std::vector<JunctionLane> lanesInto(const RoadScene& roads, int index)
{
    std::vector<JunctionLane> lanes;
    const MetRoad& road = roads.network().roads[static_cast<std::size_t>(index)];
    if (!road.isUsable || road.sections.empty()) return lanes;
    for (const bool isForward : {true, false})
        for (const auto side : {&osgRoads::core::LaneSection::left, &osgRoads::core::LaneSection::right})
            for (const Lane& lane : (isForward ? road.sections.front() : road.sections.back()).*side)
                if (osgRoads::core::isForCars(lane.type) &&
                    (lane.direction == LaneDirection::both ||
                     osgRoads::core::runsForward(road, lane) == isForward))
                    lanes.push_back({index, lane.id, isForward});
    return lanes;
}

/// Joins stretches that overlap or nearly do.
std::vector<LaneStretch> joinedStretches(std::vector<LaneStretch> stretches)
{
    constexpr double kApartM = 3.0;
    std::sort(stretches.begin(), stretches.end(),
              [](const LaneStretch& a, const LaneStretch& b) { return a.fromM < b.fromM; });
    std::vector<LaneStretch> joined;
    for (const LaneStretch& one : stretches)
        if (!joined.empty() && one.fromM < joined.back().toM + kApartM)
            joined.back().toM = std::max(joined.back().toM, one.toM);
        else
            joined.push_back(one);
    return joined;
}

} // namespace

const LaneMeetings::Bodies& LaneMeetings::bodiesOf(const JunctionLane& lane)
{
    const auto found = _bodies.find(lane);
    return found != _bodies.end() ? found->second : _bodies.emplace(lane, bodiesAlong(lane)).first->second;
}

LaneMeetings::Bodies LaneMeetings::bodiesAlong(const JunctionLane& lane) const
{
    Bodies bodies;
    const std::vector<RoadPlace> places = placesAlong(*_roads, lane, kMetStepM);
    if (places.empty()) return bodies;
    bodies.least = glm::dvec2(1e300), bodies.most = glm::dvec2(-1e300);
    double doneM = 0.0;
    for (const RoadPlace& place : places)
    {
        const RoadPose pose = _roads->poseAt(place);
        Body body;
        body.axle = glm::dvec2(pose.position);
        body.box.along = {std::cos(pose.headingRad), std::sin(pose.headingRad)};
        body.box.middle = body.axle + kMetMiddleM * body.box.along;
        body.box.halfLengthM = kMetHalfLengthM;
        body.box.halfWidthM = kMetHalfWidthM;
        body.heightM = pose.position.z;
        body.alongM = doneM;
        bodies.least = glm::min(bodies.least, body.box.middle);
        bodies.most = glm::max(bodies.most, body.box.middle);
        bodies.all.push_back(body);
        bodies.endLane = place.lane;
        doneM += kMetStepM;
    }
    return bodies;
}

const LaneMeetings::Known& LaneMeetings::knownOf(const JunctionLane& lane)
{
    if (const auto found = _known.find(lane); found != _known.end()) return found->second;
    Known known;
    std::vector<LaneStretch> stretches;
    for (const JunctionLane& other : lanesNear(lane))
    {
        if (areApart(lane, other)) continue;
        std::vector<LaneConflict> conflicts = met(lane, other);
        if (conflicts.empty()) continue;
        const double lengthM = bodiesOf(lane).all.back().alongM;
        for (const LaneConflict& conflict : conflicts)
            stretches.push_back({conflict.ownFromM, std::min(conflict.ownToM, lengthM)});
        known.others.emplace_back(other, std::move(conflicts));
    }
    known.narrow = joinedStretches(std::move(stretches));
    return _known.emplace(lane, std::move(known)).first->second;
}

/// The lanes of roads that come near, in their order.
std::vector<JunctionLane> LaneMeetings::lanesNear(const JunctionLane& lane)
{
    constexpr std::size_t kEach = 8; ///< bodies from one look to the next
    constexpr double kNearM = 2.0 * kMetHalfLengthM + kEach * kMetStepM;
    const std::vector<Body>& bodies = bodiesOf(lane).all;
    std::set<int> roads;
    for (std::size_t i = 0; i < bodies.size(); i += kEach)
        for (const int road : _roads->roadsWithin(kNearM, bodies[i].box.middle))
            roads.insert(road);
    std::vector<JunctionLane> lanes;
    for (const int road : roads)
        for (const JunctionLane& other : lanesInto(*_roads, road))
            lanes.push_back(other);
    std::sort(lanes.begin(), lanes.end());
    return lanes;
}

/// Whether two lanes cannot be in each other's way, or others see to that: the junction that has both, and
/// whoever drives behind another one.
bool LaneMeetings::areApart(const JunctionLane& own, const JunctionLane& other)
{
    constexpr double kSameM = 1.0, kSoonM = 6.0;
    if (own == other) return true;
    const auto junctionOf = [&](const JunctionLane& lane)
    { return _roads->network().roads[static_cast<std::size_t>(lane.road)].junction; };
    if (own.road == other.road && own.isForward == other.isForward) return true;
    if (junctionOf(own) >= 0 && junctionOf(own) == junctionOf(other)) return true;
    const std::vector<Body>&a = bodiesOf(own).all, &b = bodiesOf(other).all;
    if (a.empty() || b.empty()) return true;
    const bool beginAsOne = glm::distance(a.front().axle, b.front().axle) < kSameM &&
                            glm::dot(a.front().box.along, b.front().box.along) > 0.9;
    return beginAsOne || goesOnAs(own, other, kSoonM) || goesOnAs(other, own, kSoonM);
}

bool LaneMeetings::goesOnAs(const JunctionLane& own, const JunctionLane& other, double withinM)
{
    for (const RoadStep& step : stepsFrom(_roads->network(), own.road, own.isForward, bodiesOf(own).endLane))
    {
        const JunctionLane next{step.road, step.lane, step.entersAtStart};
        if (next == other) return true;
        const double lengthM = _roads->network().roads[static_cast<std::size_t>(next.road)].length;
        if (lengthM < withinM && goesOnAs(next, other, withinM - lengthM)) return true;
    }
    return false;
}

std::vector<LaneConflict> LaneMeetings::met(const JunctionLane& own, const JunctionLane& other)
{
    constexpr double kStoreyM = 3.0, kReachM = 2.0 * (kMetHalfLengthM + kMetHalfWidthM), kApartM = 3.0;
    std::vector<LaneConflict> found;
    const Bodies &a = bodiesOf(own), &b = bodiesOf(other);
    for (const Body& one : a.all)
    {
        const glm::dvec2& middle = one.box.middle;
        if (middle.x < b.least.x - kReachM || middle.x > b.most.x + kReachM ||
            middle.y < b.least.y - kReachM || middle.y > b.most.y + kReachM)
            continue;
        for (const Body& two : b.all)
        {
            const glm::dvec2 apart = two.box.middle - middle;
            if (glm::dot(apart, apart) > kReachM * kReachM ||
                std::fabs(one.heightM - two.heightM) > kStoreyM || !areMeeting(one.box, two.box))
                continue;
            if (found.empty() || one.alongM > found.back().ownToM + kApartM)
                found.push_back({one.alongM, one.alongM, two.alongM, two.alongM});
            LaneConflict& conflict = found.back();
            conflict.ownToM = one.alongM + kMetStepM;
            conflict.otherFromM = std::min(conflict.otherFromM, two.alongM);
            conflict.otherToM = std::max(conflict.otherToM, two.alongM + kMetStepM);
        }
    }
    return found;
}

std::optional<JunctionLane> LaneMeetings::laneAt(const RoadPlace& place) const
{
    if (place.road < 0) return std::nullopt;
    const bool isForward = looksForward(place);
    return JunctionLane{place.road, laneWhereEntered(_roads->roadAt(place), place.lane, place.s, isForward),
                        isForward};
}

double LaneMeetings::alongM(const JunctionLane& lane, const glm::dvec2& point)
{
    double least = 1e300, along = 0.0;
    for (const Body& body : bodiesOf(lane).all)
    {
        const glm::dvec2 apart = point - body.axle;
        const double square = glm::dot(apart, apart);
        if (square >= least) continue;
        least = square;
        along = body.alongM + glm::dot(apart, body.box.along);
    }
    return along;
}

} // namespace simulation
