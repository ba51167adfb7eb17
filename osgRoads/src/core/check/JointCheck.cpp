// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>

#include <osgRoads/core/check/JointCheck.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/read/Problem.h>

namespace osgRoads::core
{

namespace
{

/// The smaller angle between two headings.
double turnBetween(double a, double b)
{
    return std::fabs(foundation::wrappedRad(a - b));
}

/// A lane at one end of a road.
struct LaneEnd
{
    int road = -1, lane = 0;
    ContactPoint at = ContactPoint::start;
};

const LaneSection& sectionOf(const Road& road, ContactPoint at)
{
    return at == ContactPoint::start ? road.sections.front() : road.sections.back();
}

/// Compares two lane ends that ought to be one place.
class LaneJointComparison
{
public:
    LaneJointComparison(const RoadNetwork& network, const JointLimits& limits, LaneJoints& joints)
        : _network(network), _limits(limits), _joints(joints)
    {
    }

    void compare(const LaneEnd& a, const LaneEnd& b, int line)
    {
        const Road *first = usable(a.road), *second = usable(b.road);
        if (!first || !second) return;
        if (!_seen.insert(std::max(std::make_pair(tuple(a), tuple(b)), std::make_pair(tuple(b), tuple(a))))
                 .second)
            return;
        if (!hasLane(*second, b, *first, line)) return;
        if (!sectionOf(*first, a.at).lane(a.lane)) return;
        ++_joints.count;
        const RoadFrame from = frameOf(*first, a), to = frameOf(*second, b);
        const glm::dvec3 here = middle(*first, a), there = middle(*second, b);
        const std::string where = "lane " + std::to_string(a.lane) + " of road " + first->id + " and lane " +
                                  std::to_string(b.lane) + " of road " + second->id;
        const double gap = glm::length(glm::dvec2(here) - glm::dvec2(there));
        add(FlawKind::gap, gap, _limits.laneGapM, line, where + " end " + shortNumber(gap) + " m apart");
        // Roads that meet start to start, or end to end, have opposite headings there.
        const double turned = a.at == b.at ? std::numbers::pi : 0.0;
        const double kink = turnBetween(from.headingRad, to.headingRad + turned);
        add(FlawKind::kink, kink, _limits.laneKinkRad, line,
            where + " meet at " + shortNumber(kink) + " rad");
        const double step = std::fabs(here.z - there.z);
        add(FlawKind::step, step, _limits.laneStepM, line,
            where + " differ by " + shortNumber(step) + " m in height");
    }

private:
    using Tuple = std::tuple<int, int, ContactPoint>;

    static Tuple tuple(const LaneEnd& end) { return {end.road, end.lane, end.at}; }

    const Road* usable(int index) const
    {
        if (index < 0) return nullptr;
        const Road& road = _network.roads[static_cast<std::size_t>(index)];
        return road.isUsable && !road.sections.empty() ? &road : nullptr;
    }

    bool hasLane(const Road& road, const LaneEnd& end, const Road& from, int line)
    {
        if (sectionOf(road, end.at).lane(end.lane)) return true;
        _joints.flaws.push_back({FlawKind::danglingLane, line,
                                 "road " + from.id + " links to lane " + std::to_string(end.lane) +
                                     " of road " + road.id + ", which is not there",
                                 "correct the id of the lane", 0.0});
        return false;
    }

    static double endOf(const Road& road, const LaneEnd& end)
    {
        return end.at == ContactPoint::start ? 0.0 : road.length;
    }

    static RoadFrame frameOf(const Road& road, const LaneEnd& end) { return frameAt(road, endOf(road, end)); }

    static glm::dvec3 middle(const Road& road, const LaneEnd& end)
    {
        const double s = endOf(road, end);
        const std::optional<LaneSpan> span = laneSpan(road, end.lane, s);
        return surfacePoint(road, s, span ? span->centreT() : 0.0);
    }

    void add(FlawKind kind, double size, double limit, int line, const std::string& what)
    {
        if (size > limit) _joints.flaws.push_back({kind, line, what, "let them meet", size});
    }

    const RoadNetwork& _network;
    const JointLimits& _limits;
    LaneJoints& _joints;
    std::set<std::pair<Tuple, Tuple>> _seen;
};

void compareLinked(const Road& road, int index, ContactPoint at, LaneJointComparison& comparison)
{
    const std::optional<RoadLink>& link = at == ContactPoint::start ? road.predecessor : road.successor;
    if (!link || link->isJunction || link->index < 0) return;
    const LaneSection& section = sectionOf(road, at);
    for (const auto* side : {&section.left, &section.right})
        for (const Lane& lane : *side)
            for (const int linked : at == ContactPoint::start ? lane.predecessors : lane.successors)
                comparison.compare({index, lane.id, at}, {link->index, linked, link->contactPoint},
                                   lane.line);
}

/// The end of the incoming road that a connection leaves from, or nothing when neither touches the junction.
std::optional<ContactPoint> incomingEnd(const RoadNetwork& network, int junction,
                                        const JunctionConnection& connection)
{
    const Road& incoming = network.roads[static_cast<std::size_t>(connection.incomingRoad)];
    const Road& connecting = network.roads[static_cast<std::size_t>(connection.connectingRoad)];
    const std::optional<RoadLink>& back =
        connection.contactPoint == ContactPoint::start ? connecting.predecessor : connecting.successor;
    if (back && !back->isJunction && back->index == connection.incomingRoad && !back->elementS)
        return back->contactPoint;
    const auto touches = [&](const std::optional<RoadLink>& link)
    { return link && link->isJunction && link->index == junction; };
    if (touches(incoming.successor)) return ContactPoint::end;
    if (touches(incoming.predecessor)) return ContactPoint::start;
    return std::nullopt;
}

void compareJunction(const RoadNetwork& network, int index, LaneJointComparison& comparison)
{
    for (const JunctionConnection& connection :
         network.junctions[static_cast<std::size_t>(index)].connections)
    {
        if (connection.incomingRoad < 0 || connection.connectingRoad < 0) continue;
        const std::optional<ContactPoint> at = incomingEnd(network, index, connection);
        if (!at) continue;
        for (const JunctionConnection::LaneLink& link : connection.laneLinks)
            comparison.compare({connection.incomingRoad, link.from, *at},
                               {connection.connectingRoad, link.to, connection.contactPoint},
                               connection.line);
    }
}

} // namespace

const char* wordOf(FlawKind kind)
{
    constexpr const char* kWords[] = {"gap",     "kink",          "step",        "negative width",
                                      "overlap", "dangling lane", "one-way link"};
    return kWords[static_cast<std::size_t>(kind)];
}

std::vector<Flaw> checkElementJoints(const RoadNetwork& network, const JointLimits& limits)
{
    std::vector<Flaw> flaws;
    for (const Road& road : network.roads)
    {
        if (!road.isUsable) continue;
        const std::vector<PlanElement>& elements = road.referenceLine.elements();
        for (std::size_t i = 1; i < elements.size(); ++i)
        {
            const PlanPoint end = elements[i - 1].at(elements[i].s - elements[i - 1].s);
            const PlanPoint start = elements[i].at(0.0);
            const double gap = glm::length(end.position - start.position);
            const double kink = turnBetween(end.headingRad, start.headingRad);
            const std::string where = "road " + road.id + " at s " + shortNumber(elements[i].s) + ": ";
            if (gap > limits.elementGapM)
                flaws.push_back({FlawKind::gap, road.line,
                                 where + "the geometry has a gap of " + shortNumber(gap) + " m",
                                 "let the elements meet", gap});
            if (kink > limits.elementKinkRad)
                flaws.push_back({FlawKind::kink, road.line,
                                 where + "the geometry has a kink of " + shortNumber(kink) + " rad",
                                 "let the headings meet", kink});
        }
    }
    return flaws;
}

LaneJoints checkLaneJoints(const RoadNetwork& network, const JointLimits& limits)
{
    LaneJoints joints;
    LaneJointComparison comparison(network, limits, joints);
    for (std::size_t i = 0; i < network.roads.size(); ++i)
    {
        const Road& road = network.roads[i];
        if (!road.isUsable || road.sections.empty()) continue;
        compareLinked(road, static_cast<int>(i), ContactPoint::start, comparison);
        compareLinked(road, static_cast<int>(i), ContactPoint::end, comparison);
    }
    for (std::size_t i = 0; i < network.junctions.size(); ++i)
        compareJunction(network, static_cast<int>(i), comparison);
    return joints;
}

} // namespace osgRoads::core
