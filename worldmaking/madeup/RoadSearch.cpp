// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/RoadSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <boost/graph/astar_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/range/iterator_range.hpp>

namespace worldmaking
{

namespace roadsearch
{

constexpr double kDefaultGrade = 0.045; ///< doubles the cost of a metre
constexpr double kUsedShare = 0.3;      ///< of the cost where a road is there
constexpr std::array<std::array<int, 2>, 16> kSteps{{{1, 0},
                                                     {0, 1},
                                                     {-1, 0},
                                                     {0, -1},
                                                     {1, 1},
                                                     {-1, 1},
                                                     {-1, -1},
                                                     {1, -1},
                                                     {2, 1},
                                                     {1, 2},
                                                     {-1, 2},
                                                     {-2, 1},
                                                     {-2, -1},
                                                     {-1, -2},
                                                     {1, -2},
                                                     {2, -1}}};

struct RoadEdge
{
    float lengthM = 0.0F, cost = 0.0F;
    bool isUsed = false;
};

using RoadGraph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, RoadEdge>;

/// Ends a search: Boost's way out of one is an exception.
struct Arrived
{
};

} // namespace roadsearch

using namespace roadsearch;

struct RoadSearch::Graph
{
    MapBox box;
    double cellM = 1.0;
    int columns = 0, rows = 0;
    RoadGraph roads;
    std::vector<char> isFree, isUsed;
    std::vector<char> isReachable; ///< of the largest part that hangs together

    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    glm::dvec2 placeOf(std::size_t point) const
    {
        const auto width = static_cast<std::size_t>(columns);
        return box.low +
               cellM * glm::dvec2(static_cast<double>(point % width), static_cast<double>(point / width));
    }
    std::size_t nearest(const glm::dvec2& place) const
    {
        const glm::dvec2 at = glm::clamp(glm::round((place - box.low) / cellM), glm::dvec2(0.0),
                                         glm::dvec2(columns - 1, rows - 1));
        return index(static_cast<int>(at.x), static_cast<int>(at.y));
    }
};

namespace
{

/// Stops at the goal.
struct GoalWatch : boost::default_astar_visitor
{
    std::size_t goal;
    explicit GoalWatch(std::size_t point) : goal(point) {}
    void examine_vertex(std::size_t point, const RoadGraph&) const
    {
        if (point == goal) throw Arrived();
    }
};

/// Which places lie in the largest part of a graph that hangs together. Its edges lead both ways.
std::vector<char> largestPart(const RoadGraph& roads, std::size_t count)
{
    std::vector<std::uint32_t> part(count, 0), sizes{0};
    std::vector<std::size_t> waiting;
    for (std::size_t first = 0; first < count; ++first)
    {
        if (part[first] != 0) continue;
        const auto number = static_cast<std::uint32_t>(sizes.size());
        sizes.push_back(0);
        part[first] = number;
        waiting.push_back(first);
        while (!waiting.empty())
        {
            const std::size_t at = waiting.back();
            waiting.pop_back();
            ++sizes[number];
            for (const auto& edge : boost::make_iterator_range(boost::out_edges(at, roads)))
                if (const std::size_t next = boost::target(edge, roads); part[next] == 0)
                {
                    part[next] = number;
                    waiting.push_back(next);
                }
        }
    }
    const auto largest =
        static_cast<std::uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    std::vector<char> isLargest(count, 0);
    for (std::size_t i = 0; i < count; ++i)
        isLargest[i] = part[i] == largest;
    return isLargest;
}

} // namespace

RoadSearch::~RoadSearch() = default;

RoadSearch::RoadSearch(const GroundGrid& ground, double cellM, const Toll& toll)
    : _graph(std::make_unique<Graph>())
{
    Graph& graph = *_graph;
    graph.box = ground.box();
    graph.cellM = cellM;
    graph.columns = static_cast<int>((graph.box.high.x - graph.box.low.x) / cellM) + 1;
    graph.rows = static_cast<int>((graph.box.high.y - graph.box.low.y) / cellM) + 1;
    const std::size_t count = static_cast<std::size_t>(graph.columns) * static_cast<std::size_t>(graph.rows);
    std::vector<float> heights(count), tolls(count);
    graph.isFree.assign(count, 0);
    graph.isUsed.assign(count, 0);
    for (std::size_t i = 0; i < count; ++i)
    {
        const glm::dvec2 place = graph.placeOf(i);
        const auto height = ground.heightM(place);
        if (!height || !ground.isLand(place)) continue;
        heights[i] = static_cast<float>(*height);
        tolls[i] = static_cast<float>(toll(place));
        graph.isFree[i] = tolls[i] > 0.0F;
    }
    std::vector<std::pair<std::size_t, std::size_t>> ends;
    std::vector<RoadEdge> edges;
    for (int row = 0; row < graph.rows; ++row)
        for (int column = 0; column < graph.columns; ++column)
            for (const auto& [dx, dy] : kSteps)
            {
                const int x = column + dx, y = row + dy;
                if (x < 0 || y < 0 || x >= graph.columns || y >= graph.rows) continue;
                const std::size_t from = graph.index(column, row), to = graph.index(x, y);
                if (!graph.isFree[from] || !graph.isFree[to]) continue;
                const double lengthM = cellM * std::hypot(dx, dy);
                const double grade = std::abs(heights[to] - heights[from]) / lengthM;
                if (grade > kSteepest) continue;
                const double share = grade / kDefaultGrade;
                ends.emplace_back(from, to);
                edges.push_back(
                    {static_cast<float>(lengthM),
                     static_cast<float>(lengthM * (0.5 * (tolls[from] + tolls[to]) + share * share)), false});
            }
    graph.roads = RoadGraph(boost::edges_are_sorted, ends.begin(), ends.end(), edges.begin(), count);
    graph.isReachable = largestPart(graph.roads, count);
}

std::vector<glm::dvec2> RoadSearch::path(const glm::dvec2& from, const glm::dvec2& to) const
{
    const Graph& graph = *_graph;
    const std::size_t start = graph.nearest(from), goal = graph.nearest(to);
    if (!graph.isFree[start] || !graph.isFree[goal]) return {};
    std::vector<std::size_t> before(graph.isFree.size());
    const glm::dvec2 end = graph.placeOf(goal);
    const auto cost = [](const RoadEdge& edge)
    { return edge.isUsed ? kUsedShare * edge.cost : 1.0 * edge.cost; };
    bool hasArrived = false;
    try
    {
        boost::astar_search(
            graph.roads, start,
            [&](std::size_t point) { return kUsedShare * glm::distance(graph.placeOf(point), end); },
            boost::predecessor_map(
                boost::make_iterator_property_map(before.begin(), get(boost::vertex_index, graph.roads)))
                .weight_map(
                    boost::make_transform_value_property_map(cost, get(boost::edge_bundle, graph.roads)))
                .visitor(GoalWatch(goal)));
    }
    catch (const Arrived&)
    {
        hasArrived = true;
    }
    std::vector<glm::dvec2> path;
    if (!hasArrived) return path;
    for (std::size_t at = goal; at != start; at = before[at])
        path.push_back(graph.placeOf(at));
    path.push_back(graph.placeOf(start));
    std::reverse(path.begin(), path.end());
    return path;
}

void RoadSearch::use(const std::vector<glm::dvec2>& path)
{
    Graph& graph = *_graph;
    for (std::size_t i = 0; i < path.size(); ++i)
    {
        const std::size_t at = graph.nearest(path[i]);
        graph.isUsed[at] = 1;
        if (i + 1 == path.size()) break;
        const std::size_t next = graph.nearest(path[i + 1]);
        for (const auto& [from, to] : {std::pair(at, next), std::pair(next, at)})
            for (const auto& edge : boost::make_iterator_range(boost::out_edges(from, graph.roads)))
                if (boost::target(edge, graph.roads) == to) graph.roads[edge].isUsed = true;
    }
}

bool RoadSearch::isReachable(const glm::dvec2& place) const
{
    const std::size_t point = _graph->nearest(place);
    return _graph->isFree[point] != 0 && _graph->isReachable[point] != 0;
}

bool RoadSearch::isUsed(const glm::dvec2& place) const
{
    return _graph->isUsed[_graph->nearest(place)] != 0;
}

} // namespace worldmaking
