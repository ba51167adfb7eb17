// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/StreetGraph.h"

#include <algorithm>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

namespace worldmaking
{

namespace
{

constexpr int kNone = -1;

using TraitsRule = std::function<std::optional<StreetTraits>(const Tags&)>;

/// A piece of a way between two neighbouring nodes.
struct Segment
{
    std::uint32_t from, to;
    std::size_t forward, backward; ///< its traits seen from either end
    std::int64_t way;
    bool isUsed = false;
};

/// Finds the chains of a map: pieces one behind the other, between points where not exactly two of them meet.
class ChainFinder
{
public:
    ChainFinder(const StreetMap& map, StreetGraph& graph, const TraitsRule& rule)
        : _graph(graph), _rule(rule), _meeting(map.nodes.size())
    {
        for (const MapWay& way : map.ways)
            addWay(way);
        for (std::size_t i = 0; i < _segments.size(); ++i)
            for (const std::uint32_t point : {_segments[i].from, _segments[i].to})
                _meeting[point].push_back(i);
    }

    void find()
    {
        _crossings.assign(_meeting.size(), kNone);
        for (std::uint32_t point = 0; point < _meeting.size(); ++point)
            if (_meeting[point].size() > 2) makeCrossing(point);
        for (std::uint32_t point = 0; point < _meeting.size(); ++point)
            if (!_meeting[point].empty() && _meeting[point].size() != 2) followAll(point);
        for (const Segment& segment : _segments) // what is left are rings
            if (!segment.isUsed)
            {
                makeCrossing(segment.from);
                followAll(segment.from);
            }
    }

private:
    void addWay(const MapWay& way)
    {
        const auto traits = _rule(way.tags);
        if (!traits)
        {
            ++_graph.closedWays;
            return;
        }
        const std::size_t forward = _graph.traits.size();
        _graph.traits.push_back(*traits);
        _graph.traits.push_back(traits->reversed());
        for (std::size_t i = 0; i + 1 < way.nodes.size(); ++i)
        {
            const std::uint32_t from = way.nodes[i], to = way.nodes[i + 1];
            if (from == to || !_pairs.insert(std::minmax(from, to)).second) continue;
            _segments.push_back({from, to, forward, forward + 1, way.id});
        }
    }

    void makeCrossing(std::uint32_t point)
    {
        if (_crossings[point] != kNone) return;
        _crossings[point] = static_cast<int>(_graph.crossings.size());
        _graph.crossings.push_back({{point}, {}});
    }

    void followAll(std::uint32_t point)
    {
        for (const std::size_t segment : _meeting[point])
            if (!_segments[segment].isUsed) follow(point, segment);
    }

    void follow(std::uint32_t point, std::size_t index)
    {
        StreetChain chain;
        chain.startCrossing = _crossings[point];
        chain.points.push_back(point);
        for (;;)
        {
            Segment& segment = _segments[index];
            segment.isUsed = true;
            const bool isForward = segment.from == point;
            chain.pieces.push_back({isForward ? segment.forward : segment.backward, segment.way});
            point = isForward ? segment.to : segment.from;
            chain.points.push_back(point);
            if (_meeting[point].size() != 2 || _crossings[point] != kNone) break;
            index = _meeting[point][0] == index ? _meeting[point][1] : _meeting[point][0];
        }
        chain.endCrossing = _crossings[point];
        _graph.chains.push_back(std::move(chain));
    }

    StreetGraph& _graph;
    const TraitsRule& _rule;
    std::vector<Segment> _segments;
    std::set<std::pair<std::uint32_t, std::uint32_t>> _pairs;
    std::vector<std::vector<std::size_t>> _meeting; ///< segments at each point
    std::vector<int> _crossings;                    ///< of each point
};

double lengthOf(const StreetChain& chain, const std::vector<glm::dvec2>& places)
{
    double lengthM = 0.0;
    for (std::size_t i = 0; i + 1 < chain.points.size(); ++i)
        lengthM += glm::distance(places[chain.points[i]], places[chain.points[i + 1]]);
    return lengthM;
}

int rootOf(std::vector<int>& parents, int crossing)
{
    while (parents[static_cast<std::size_t>(crossing)] != crossing)
        crossing = parents[static_cast<std::size_t>(crossing)];
    return crossing;
}

/// Takes out chains that are too short, and makes one crossing of those at their ends.
void joinCrossings(StreetGraph& graph, const std::vector<glm::dvec2>& places, double shortestM)
{
    std::vector<int> parents(graph.crossings.size());
    for (std::size_t i = 0; i < parents.size(); ++i)
        parents[i] = static_cast<int>(i);
    const auto isShort = [&](const StreetChain& chain)
    {
        const bool isBetween = chain.startCrossing != kNone && chain.endCrossing != kNone;
        if (!isBetween || lengthOf(chain, places) >= shortestM) return false;
        const int a = rootOf(parents, chain.startCrossing), b = rootOf(parents, chain.endCrossing);
        parents[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
        return true;
    };
    graph.chains.erase(std::remove_if(graph.chains.begin(), graph.chains.end(), isShort), graph.chains.end());
    std::vector<int> renumbered(parents.size(), kNone);
    std::vector<Crossing> kept;
    for (std::size_t i = 0; i < parents.size(); ++i)
    {
        const auto root = static_cast<std::size_t>(rootOf(parents, static_cast<int>(i)));
        if (renumbered[root] == kNone)
        {
            renumbered[root] = static_cast<int>(kept.size());
            kept.emplace_back();
        }
        renumbered[i] = renumbered[root];
        auto& points = kept[static_cast<std::size_t>(renumbered[i])].points;
        points.push_back(graph.crossings[i].points.front());
    }
    graph.crossings = std::move(kept);
    for (StreetChain& chain : graph.chains)
        for (int* crossing : {&chain.startCrossing, &chain.endCrossing})
            if (*crossing != kNone) *crossing = renumbered[static_cast<std::size_t>(*crossing)];
}

void addArms(StreetGraph& graph)
{
    for (std::size_t i = 0; i < graph.chains.size(); ++i)
    {
        const StreetChain& chain = graph.chains[i];
        if (chain.startCrossing != kNone)
            graph.crossings[static_cast<std::size_t>(chain.startCrossing)].arms.push_back({i, false});
        if (chain.endCrossing != kNone)
            graph.crossings[static_cast<std::size_t>(chain.endCrossing)].arms.push_back({i, true});
    }
}

} // namespace

StreetGraph graphOf(const StreetMap& map, const std::vector<glm::dvec2>& places, double shortestM,
                    const std::function<std::optional<StreetTraits>(const Tags&)>& traits)
{
    StreetGraph graph;
    ChainFinder(map, graph, traits).find();
    joinCrossings(graph, places, shortestM);
    addArms(graph);
    return graph;
}

} // namespace worldmaking
