// SPDX-License-Identifier: Apache-2.0
// Source: Dijkstra, *A note on two problems in connexion with graphs*, 1959.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include <osgRoads/core/query/LaneRoute.h>
#include <osgRoads/core/query/LaneSpan.h>

namespace osgRoads::core
{

namespace
{

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// One search: costs are measured at the point of each lane that lies as far along it as one has come.
class RouteSearch
{
public:
    RouteSearch(const LaneGraph& graph, std::uint32_t start, std::uint32_t goal)
        : _graph(graph),
          _start(start),
          _goal(goal),
          _costs(graph.lanes().size(), std::numeric_limits<double>::infinity()),
          _from(graph.lanes().size(), kNone),
          _isSideways(graph.lanes().size(), false)
    {
    }

    /// `restOfStart`: metres from the start to the end of its lane.
    bool run(double restOfStart)
    {
        _costs[_start] = 0.0;
        _queue.push({0.0, _start});
        while (!_queue.empty())
        {
            const auto [cost, lane] = _queue.top();
            _queue.pop();
            if (lane == _goal) return true;
            if (cost > _costs[lane]) continue;
            const double length = isFromStart(lane) ? restOfStart : _graph.lengthM(lane);
            for (const LaneGraph::Edge& edge : _graph.edges(lane))
                reach(edge, lane, cost + (edge.isLaneChange ? kLaneChangeM : length));
        }
        return false;
    }

    /// The lanes from the start to the goal.
    std::vector<std::pair<std::uint32_t, bool>> lanes() const
    {
        std::vector<std::pair<std::uint32_t, bool>> found;
        for (std::uint32_t lane = _goal; lane != kNone; lane = lane == _start ? kNone : _from[lane])
            found.emplace_back(lane, lane != _start && _isSideways[lane]);
        std::reverse(found.begin(), found.end());
        return found;
    }

private:
    struct Open
    {
        double cost;
        std::uint32_t lane;
        bool operator>(const Open& other) const
        {
            return cost != other.cost ? cost > other.cost : lane > other.lane;
        }
    };

    /// The start, and lanes beside it that were reached without driving on.
    bool isFromStart(std::uint32_t lane) const
    {
        while (lane != _start && _isSideways[lane])
            lane = _from[lane];
        return lane == _start;
    }

    void reach(const LaneGraph::Edge& edge, std::uint32_t from, double cost)
    {
        if (!(cost < _costs[edge.to])) return;
        _costs[edge.to] = cost;
        _from[edge.to] = from;
        _isSideways[edge.to] = edge.isLaneChange;
        _queue.push({cost, edge.to});
    }

    const LaneGraph& _graph;
    std::uint32_t _start, _goal;
    std::vector<double> _costs;
    std::vector<std::uint32_t> _from;
    std::vector<bool> _isSideways;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> _queue;
};

foundation::Result<std::uint32_t> laneOf(const RoadNetwork& network, const LaneGraph& graph,
                                         const RoadPosition& position, const char* which)
{
    const foundation::Error none{"route", std::string("the ") + which + " is on no lane that cars use",
                                 "move it onto a driving lane"};
    if (position.road < 0 || static_cast<std::size_t>(position.road) >= network.roads.size()) return none;
    const Road& road = network.roads[static_cast<std::size_t>(position.road)];
    const std::optional<LaneSpan> span = laneAt(road, position.s, position.t);
    if (!span) return none;
    const int section = std::max(lastStartingBy(road.sections, position.s), 0);
    const LaneKey key{position.road, section, span->lane->id, runsForward(road, *span->lane)};
    const std::optional<std::uint32_t> found = graph.find(key);
    return found ? foundation::Result<std::uint32_t>(*found) : none;
}

/// The legs of a list of lanes: whole ones, but for the first and the last.
LaneRoute routeOver(const RoadNetwork& network, const LaneGraph& graph, const RouteSearch& search,
                    double sFrom, double sTo)
{
    LaneRoute route;
    const auto lanes = search.lanes();
    double entered = sFrom;
    for (std::size_t i = 0; i < lanes.size(); ++i)
    {
        const auto& [index, isSideways] = lanes[i];
        const LaneKey& key = graph.lanes()[index];
        const LaneSection& section =
            network.roads[static_cast<std::size_t>(key.road)].sections[static_cast<std::size_t>(key.section)];
        const double begin = key.isForward ? section.s : section.end;
        const double end = key.isForward ? section.end : section.s;
        RouteLeg leg{key, i > 0 && !isSideways ? begin : entered, end, isSideways};
        if (i + 1 == lanes.size())
            leg.sTo = sTo;
        else if (lanes[i + 1].second)
            leg.sTo = leg.sFrom;
        entered = leg.sTo;
        route.lengthM += std::fabs(leg.sTo - leg.sFrom);
        route.legs.push_back(leg);
    }
    return route;
}

} // namespace

foundation::Result<LaneRoute> findRoute(const RoadNetwork& network, const LaneGraph& graph,
                                        const RoadPosition& from, const RoadPosition& to)
{
    const auto start = laneOf(network, graph, from, "start");
    if (!start) return start.error();
    const auto goal = laneOf(network, graph, to, "goal");
    if (!goal) return goal.error();
    const LaneKey key = graph.lanes()[*start];
    const LaneKey goalKey = graph.lanes()[*goal];
    const LaneSection& section =
        network.roads[static_cast<std::size_t>(key.road)].sections[static_cast<std::size_t>(key.section)];
    const bool isBehind = key.road == goalKey.road && key.section == goalKey.section &&
                          key.isForward == goalKey.isForward &&
                          (key.isForward ? to.s < from.s : to.s > from.s);
    RouteSearch search(graph, *start, *goal);
    if (isBehind || !search.run(key.isForward ? section.end - from.s : from.s - section.s))
        return foundation::Error{
            "route",
            isBehind ? "the goal is behind the start on the same road" : "no route leads to the goal",
            isBehind ? "name a position on the way first" : "check the links of roads, lanes and junctions"};
    return routeOver(network, graph, search, from.s, to.s);
}

RoadPosition LaneRoute::at(const RoadNetwork& network, double distanceM) const
{
    double rest = std::clamp(distanceM, 0.0, lengthM);
    const RouteLeg* on = &legs.back();
    for (const RouteLeg& leg : legs)
    {
        const double length = std::fabs(leg.sTo - leg.sFrom);
        if (rest <= length && length > 0.0)
        {
            on = &leg;
            break;
        }
        rest -= length;
    }
    const double length = std::fabs(on->sTo - on->sFrom);
    const double share = length > 0.0 ? std::clamp(rest / length, 0.0, 1.0) : 1.0;
    const double s = on->sFrom + (on->sTo - on->sFrom) * share;
    return laneCentre(network, on->lane.road, on->lane.lane, s)
        .value_or(RoadPosition{on->lane.road, s, 0.0, 0.0});
}

} // namespace osgRoads::core
