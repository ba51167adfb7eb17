// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/JunctionTable.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>

#include <osgRoads/core/query/LaneSpan.h>

#include "simulation/road/RoadWalk.h"

namespace simulation
{
namespace
{

using osgRoads::core::Junction;
using osgRoads::core::JunctionConnection;
using osgRoads::core::Lane;
using osgRoads::core::Road;
using Network = osgRoads::core::RoadNetwork;
using osgRoads::core::Signal;

constexpr double kShapeStepM = 1.0, kBodyM = 5.0;

/// The box of a van, with some room, whose rear axle is there.
BodyBox bodyAt(const glm::dvec2& axle, double headingRad)
{
    constexpr double kMiddleM = 1.65, kHalfLengthM = 2.95, kHalfWidthM = 1.05;
    const glm::dvec2 along(std::cos(headingRad), std::sin(headingRad));
    return {axle + kMiddleM * along, along, kHalfLengthM, kHalfWidthM};
}

const Road& roadOf(const Network& network, int road)
{
    return network.roads[static_cast<std::size_t>(road)];
}

/// Whether all lanes for cars of a road run one way.
bool isOneWay(const Road& road, bool isForward)
{
    if (road.sections.empty()) return false;
    const auto runsBack = [&](const Lane& lane)
    { return osgRoads::core::isForCars(lane.type) && osgRoads::core::runsForward(road, lane) != isForward; };
    const osgRoads::core::LaneSection& section = road.sections.front();
    return std::none_of(section.left.begin(), section.left.end(), runsBack) &&
           std::none_of(section.right.begin(), section.right.end(), runsBack);
}

/// The lane of a road's end that a lane of its begin goes on as.
int laneAtEnd(const Road& road, int lane, bool isForward)
{
    const std::size_t count = road.sections.size();
    for (std::size_t i = 0; i + 1 < count; ++i)
    {
        const Lane* const here = road.sections[isForward ? i : count - 1 - i].lane(lane);
        if (!here) break;
        const auto& links = isForward ? here->successors : here->predecessors;
        if (!links.empty()) lane = links.front();
    }
    return lane;
}

} // namespace

int JunctionTable::junctionOf(int road) const
{
    return road < 0 ? -1 : roadOf(_roads->network(), road).junction;
}

const JunctionTable::Shape& JunctionTable::shapeOf(const JunctionLane& lane)
{
    const auto found = _shapes.find(lane);
    return found != _shapes.end() ? found->second : _shapes.emplace(lane, shaped(lane)).first->second;
}

JunctionTable::Shape JunctionTable::shaped(const JunctionLane& lane) const
{
    Shape shape;
    const std::vector<RoadPlace> places = placesAlong(*_roads, lane, kShapeStepM);
    if (places.empty()) return shape;
    double doneM = 0.0;
    for (const RoadPlace& place : places)
    {
        const RoadPose pose = _roads->poseAt(place);
        if (shape.bodies.empty())
        {
            // Its front is in the junction before its rear axle.
            const glm::dvec2 ahead(std::cos(pose.headingRad), std::sin(pose.headingRad));
            for (double beforeM = kBodyM; beforeM > 0.0; beforeM -= kShapeStepM)
                shape.bodies.push_back(
                    {glm::dvec2(pose.position) - beforeM * ahead, pose.headingRad, -beforeM});
        }
        shape.bodies.push_back({glm::dvec2(pose.position), pose.headingRad, doneM});
        doneM += kShapeStepM;
    }
    shape.turnRad = foundation::wrappedRad(shape.bodies.back().headingRad - shape.bodies.front().headingRad);
    findIncoming(lane, shape);
    shape.isInRing = shape.incoming >= 0 && isRing(shape.incoming, shape.comesForward);
    return shape;
}

void JunctionTable::findIncoming(const JunctionLane& lane, Shape& shape) const
{
    const Network& network = _roads->network();
    const int junction = junctionOf(lane.road);
    if (junction < 0) return;
    for (const JunctionConnection& connection :
         network.junctions[static_cast<std::size_t>(junction)].connections)
    {
        const bool entersAtStart = connection.contactPoint == osgRoads::core::ContactPoint::start;
        if (connection.connectingRoad != lane.road || entersAtStart != lane.isForward ||
            connection.incomingRoad < 0)
            continue;
        shape.incoming = connection.incomingRoad;
        const auto& link = roadOf(network, shape.incoming).successor;
        shape.comesForward = link && link->isJunction && link->index == junction;
        return;
    }
}

/// A ring of one-way roads that turns once, to the left in right-hand traffic, within 300 m.
bool JunctionTable::isRing(int road, bool isForward) const
{
    constexpr double kMostM = 300.0, kWholeRad = 1.5 * std::numbers::pi;
    constexpr int kMostRoads = 40;
    const Network& network = _roads->network();
    if (!isOneWay(roadOf(network, road), isForward)) return false;
    double doneM = 0.0, turnedRad = 0.0;
    int at = road;
    bool atForward = isForward;
    const auto turnOf = [](const Road& of, bool along)
    {
        double turned = 0.0;
        constexpr int kParts = 8;
        for (int i = 0; i < kParts; ++i)
            turned += foundation::wrappedRad(of.referenceLine.at(of.length * (i + 1) / kParts).headingRad -
                                             of.referenceLine.at(of.length * i / kParts).headingRad);
        return along ? turned : -turned;
    };
    for (int count = 0; count < kMostRoads && doneM < kMostM; ++count)
    {
        const Road& here = roadOf(network, at);
        doneM += here.length;
        turnedRad += turnOf(here, atForward);
        // The one-way road that turns most to the inside is the ring's.
        const double inside = here.isLeftHandTraffic ? -1.0 : 1.0;
        double most = -1e9;
        int next = -1;
        bool nextForward = true;
        for (const RoadStep& step : stepsFrom(network, at, atForward, 0))
        {
            const Road& to = roadOf(network, step.road);
            if (!isOneWay(to, step.entersAtStart)) continue;
            const double turn = inside * turnOf(to, step.entersAtStart);
            if (turn <= most) continue;
            most = turn;
            next = step.road;
            nextForward = step.entersAtStart;
        }
        if (next == road) return inside * turnedRad > kWholeRad;
        if (next < 0) return false;
        at = next;
        atForward = nextForward;
    }
    return false;
}

const LaneConflict* JunctionTable::conflict(const JunctionLane& own, const JunctionLane& other)
{
    const auto key = std::make_pair(own, other);
    auto found = _conflicts.find(key);
    if (found == _conflicts.end())
    {
        constexpr double kSameM = 1.0;
        const std::vector<Body>&a = shapeOf(own).bodies, &b = shapeOf(other).bodies;
        std::pair<bool, LaneConflict> entry{false, {1e9, -1e9, 1e9, -1e9}};
        const bool isOneLane = own == other || a.empty() || b.empty() ||
                               glm::distance(a.front().place, b.front().place) < kSameM;
        for (std::size_t i = 0; !isOneLane && i < a.size(); ++i)
            for (std::size_t j = 0; j < b.size(); ++j)
            {
                if (!areMeeting(bodyAt(a[i].place, a[i].headingRad), bodyAt(b[j].place, b[j].headingRad)))
                    continue;
                entry.first = true;
                LaneConflict& conflict = entry.second;
                conflict.ownFromM = std::min(conflict.ownFromM, a[i].alongM);
                conflict.ownToM = std::max(conflict.ownToM, a[i].alongM + kShapeStepM);
                conflict.otherFromM = std::min(conflict.otherFromM, b[j].alongM);
                conflict.otherToM = std::max(conflict.otherToM, b[j].alongM + kShapeStepM);
            }
        found = _conflicts.emplace(key, entry).first;
    }
    return found->second.first ? &found->second.second : nullptr;
}

JunctionTable::Sign JunctionTable::signOf(const Shape& shape) const
{
    constexpr double kNearM = 60.0;
    if (shape.incoming < 0) return Sign::none;
    const Road& road = roadOf(_roads->network(), shape.incoming);
    Sign sign = Sign::none;
    for (const Signal& signal : road.signals)
    {
        if (signal.orientation != '0' && (signal.orientation == '+') != shape.comesForward) continue;
        if (std::fabs((shape.comesForward ? road.length : 0.0) - signal.s) > kNearM) continue;
        if (signal.type == "205" || signal.type == "206") return Sign::givesWay;
        if (signal.type == "301" || signal.type == "306") sign = Sign::hasPriority;
    }
    return sign;
}

bool JunctionTable::staysInRing(const JunctionLane& lane)
{
    const Shape& shape = shapeOf(lane);
    const double inside = roadOf(_roads->network(), lane.road).isLeftHandTraffic ? -1.0 : 1.0;
    return shape.isInRing && inside * shape.turnRad >= 0.0;
}

bool JunctionTable::goesBefore(const JunctionLane& other, const JunctionLane& own, bool byLights)
{
    auto& known = byLights ? _beforeByLights : _before;
    const auto key = std::make_pair(other, own);
    if (const auto found = known.find(key); found != known.end()) return found->second;
    return known.emplace(key, decide(other, own, byLights)).first->second;
}

bool JunctionTable::decide(const JunctionLane& other, const JunctionLane& own, bool byLights)
{
    constexpr double kFacingRad = 2.6, kAlongRad = 0.35, kTurnRad = 0.5;
    const Shape &theirs = shapeOf(other), &mine = shapeOf(own);
    if (theirs.bodies.empty() || mine.bodies.empty()) return false;
    if (!byLights)
        if (const auto ruled = byPriority(other, own)) return *ruled;
    if (theirs.isInRing != mine.isInRing) return theirs.isInRing;
    const bool isLeftHand = roadOf(_roads->network(), own.road).isLeftHandTraffic;
    const double side = isLeftHand ? -1.0 : 1.0;
    const double across =
        side * foundation::wrappedRad(theirs.bodies.front().headingRad - mine.bodies.front().headingRad);
    if (std::fabs(across) > kFacingRad)
        return side * mine.turnRad > kTurnRad && side * theirs.turnRad <= kTurnRad;
    return across > kAlongRad;
}

/// By priorities of the junction, then by signs; nothing: neither says who goes first.
std::optional<bool> JunctionTable::byPriority(const JunctionLane& other, const JunctionLane& own)
{
    const Shape &theirs = shapeOf(other), &mine = shapeOf(own);
    const Network& network = _roads->network();
    const int junction = junctionOf(own.road);
    if (junction >= 0 && theirs.incoming >= 0 && mine.incoming >= 0)
        for (const auto& priority : network.junctions[static_cast<std::size_t>(junction)].priorities)
        {
            const auto is = [&](const std::string& id, const Shape& shape, const JunctionLane& lane)
            { return id == roadOf(network, shape.incoming).id || id == roadOf(network, lane.road).id; };
            if (is(priority.high, theirs, other) && is(priority.low, mine, own)) return true;
            if (is(priority.high, mine, own) && is(priority.low, theirs, other)) return false;
        }
    const Sign theirSign = signOf(theirs), mySign = signOf(mine);
    if (theirSign != mySign) return mySign == Sign::givesWay || theirSign == Sign::hasPriority;
    return std::nullopt;
}

bool JunctionTable::leadsOn(const JunctionLane& lane)
{
    constexpr double kLongM = 1000.0;
    if (!_hasEnds) findEnds();
    const auto found = _endsAfterM.find(lane);
    return found == _endsAfterM.end() || found->second > kLongM;
}

/// Takes away, again and again, lanes that nothing follows but what was taken away.
void JunctionTable::findEnds()
{
    _hasEnds = true;
    const Network& network = _roads->network();
    std::map<JunctionLane, int> ways; ///< on which it goes on
    std::map<JunctionLane, std::vector<JunctionLane>> before;
    const auto add = [&](const JunctionLane& from, const Road& road)
    {
        int& count = ways[from];
        for (const RoadStep& step :
             stepsFrom(network, from.road, from.isForward, laneAtEnd(road, from.lane, from.isForward)))
        {
            before[{step.road, step.lane, step.entersAtStart}].push_back(from);
            ++count;
        }
    };
    for (std::size_t i = 0; i < network.roads.size(); ++i)
    {
        const Road& road = network.roads[i];
        if (!road.isUsable || road.sections.empty()) continue;
        for (const bool isForward : {true, false})
            for (const auto side : {&osgRoads::core::LaneSection::left, &osgRoads::core::LaneSection::right})
                for (const Lane& lane : (isForward ? road.sections.front() : road.sections.back()).*side)
                    if (osgRoads::core::isForCars(lane.type) &&
                        osgRoads::core::runsForward(road, lane) == isForward)
                        add({static_cast<int>(i), lane.id, isForward}, road);
    }
    std::map<JunctionLane, double> longest;
    std::vector<std::pair<JunctionLane, double>> ended; ///< with the longest way behind it
    for (const auto& [lane, count] : ways)
        if (count == 0) ended.emplace_back(lane, 0.0);
    while (!ended.empty())
    {
        const auto [lane, behindM] = ended.back();
        ended.pop_back();
        const double endsAfterM = behindM + roadOf(network, lane.road).length;
        if (!_endsAfterM.emplace(lane, endsAfterM).second) continue;
        for (const JunctionLane& from : before[lane])
        {
            longest[from] = std::max(longest[from], endsAfterM);
            if (--ways[from] == 0) ended.emplace_back(from, longest[from]);
        }
    }
    if (_endsAfterM.size() == ways.size()) _endsAfterM.clear(); // all roads end: none is better
}

} // namespace simulation
