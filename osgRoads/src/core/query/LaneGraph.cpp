// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 10.3 (road linkage), 11.5 (lane linkage), 12 (junctions).
#include <algorithm>

#include <osgRoads/core/query/LaneGraph.h>
#include <osgRoads/core/query/LaneSpan.h>

namespace osgRoads::core
{

namespace
{

bool isDrivenForward(const Road& road, const Lane& lane)
{
    return lane.direction == LaneDirection::both || lane.type == LaneType::bidirectional ||
           runsForward(road, lane);
}

bool isDrivenBackward(const Road& road, const Lane& lane)
{
    return lane.direction == LaneDirection::both || lane.type == LaneType::bidirectional ||
           !runsForward(road, lane);
}

} // namespace

/// Makes the lanes, then the edges.
class LaneGraphBuilder
{
public:
    LaneGraphBuilder(const RoadNetwork& network, LaneGraph& graph) : _network(network), _graph(graph) {}

    void build()
    {
        addLanes();
        indexJunctions();
        _graph._edges.resize(_graph._lanes.size());
        for (std::uint32_t i = 0; i < _graph._lanes.size(); ++i)
        {
            addAlong(i);
            addSideways(i);
        }
    }

private:
    struct Way
    {
        int junction;
        const JunctionConnection* connection;
    };

    const Road& roadOf(int index) const { return _network.roads[static_cast<std::size_t>(index)]; }

    const Lane& laneOf(const LaneKey& key) const
    {
        return *roadOf(key.road).sections[static_cast<std::size_t>(key.section)].lane(key.lane);
    }

    void addLanes()
    {
        for (int road = 0; road < static_cast<int>(_network.roads.size()); ++road)
        {
            _graph._firstOfRoad.push_back(static_cast<std::uint32_t>(_graph._lanes.size()));
            const Road& on = roadOf(road);
            for (int section = 0; on.isUsable && section < static_cast<int>(on.sections.size()); ++section)
            {
                const LaneSection& lanes = on.sections[static_cast<std::size_t>(section)];
                for (const auto* side : {&lanes.left, &lanes.right})
                    for (const Lane& lane : *side)
                        addLane(on, lanes, lane, {road, section, lane.id, true});
            }
        }
        _graph._firstOfRoad.push_back(static_cast<std::uint32_t>(_graph._lanes.size()));
    }

    void addLane(const Road& road, const LaneSection& section, const Lane& lane, LaneKey key)
    {
        if (!isForCars(lane.type)) return;
        for (const bool isForward : {true, false})
        {
            if (isForward ? !isDrivenForward(road, lane) : !isDrivenBackward(road, lane)) continue;
            key.isForward = isForward;
            _graph._lanes.push_back(key);
            _graph._lengths.push_back(std::max(section.end - section.s, 0.0));
        }
    }

    /// The connections that leave each road.
    void indexJunctions()
    {
        _ways.resize(_network.roads.size());
        for (int junction = 0; junction < static_cast<int>(_network.junctions.size()); ++junction)
            for (const JunctionConnection& connection :
                 _network.junctions[static_cast<std::size_t>(junction)].connections)
                if (connection.incomingRoad >= 0 && connection.connectingRoad >= 0)
                    _ways[static_cast<std::size_t>(connection.incomingRoad)].push_back(
                        {junction, &connection});
    }

    void connect(std::uint32_t from, const LaneKey& to, bool isLaneChange)
    {
        const std::optional<std::uint32_t> found = _graph.find(to);
        if (!found || *found == from) return;
        std::vector<LaneGraph::Edge>& edges = _graph._edges[from];
        if (std::none_of(edges.begin(), edges.end(),
                         [&](const LaneGraph::Edge& edge) { return edge.to == *found; }))
            edges.push_back({*found, isLaneChange});
    }

    /// Enters a road at its start or its end.
    void enter(std::uint32_t from, int road, ContactPoint at, int laneId)
    {
        const int last = static_cast<int>(roadOf(road).sections.size()) - 1;
        if (at == ContactPoint::start)
            connect(from, {road, 0, laneId, true}, false);
        else
            connect(from, {road, last, laneId, false}, false);
    }

    void addAlong(std::uint32_t index)
    {
        const LaneKey key = _graph._lanes[index];
        const Road& road = roadOf(key.road);
        const Lane& lane = laneOf(key);
        const std::vector<int>& linked = key.isForward ? lane.successors : lane.predecessors;
        const int next = key.section + (key.isForward ? 1 : -1);
        if (next >= 0 && next < static_cast<int>(road.sections.size()))
        {
            for (const int id : linked)
                connect(index, {key.road, next, id, key.isForward}, false);
            return;
        }
        const std::optional<RoadLink>& link = key.isForward ? road.successor : road.predecessor;
        if (!link || link->index < 0) return;
        if (!link->isJunction)
            for (const int id : linked)
                enter(index, link->index, link->contactPoint, id);
        else
            addJunction(index, key, link->index);
    }

    void addJunction(std::uint32_t index, const LaneKey& key, int junction)
    {
        for (const Way& way : _ways[static_cast<std::size_t>(key.road)])
        {
            if (way.junction != junction || !leavesFrom(*way.connection, key)) continue;
            for (const JunctionConnection::LaneLink& link : way.connection->laneLinks)
                if (link.from == key.lane)
                    enter(index, way.connection->connectingRoad, way.connection->contactPoint, link.to);
        }
    }

    /// A road may touch one junction with both ends: the link of the connecting road tells which end is
    /// meant.
    bool leavesFrom(const JunctionConnection& connection, const LaneKey& key) const
    {
        const Road& connecting = roadOf(connection.connectingRoad);
        const std::optional<RoadLink>& back =
            connection.contactPoint == ContactPoint::start ? connecting.predecessor : connecting.successor;
        if (!back || back->isJunction || back->index != key.road) return true;
        return (back->contactPoint == ContactPoint::end) == key.isForward;
    }

    void addSideways(std::uint32_t index)
    {
        const LaneKey key = _graph._lanes[index];
        for (const int step : {-1, 1})
        {
            LaneKey beside = key;
            beside.lane += step;
            if (beside.lane == 0) beside.lane += step; // over the centre, where that side runs the same way
            connect(index, beside, true);
        }
    }

    const RoadNetwork& _network;
    LaneGraph& _graph;
    std::vector<std::vector<Way>> _ways;
};

LaneGraph::LaneGraph(const RoadNetwork& network)
{
    LaneGraphBuilder(network, *this).build();
}

std::optional<std::uint32_t> LaneGraph::find(const LaneKey& key) const
{
    const auto road = static_cast<std::size_t>(key.road);
    if (key.road < 0 || road + 1 >= _firstOfRoad.size()) return std::nullopt;
    for (std::uint32_t i = _firstOfRoad[road]; i < _firstOfRoad[road + 1]; ++i)
        if (_lanes[i] == key) return i;
    return std::nullopt;
}

} // namespace osgRoads::core
