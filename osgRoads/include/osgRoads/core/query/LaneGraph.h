// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <osgRoads/core/query/RoadPosition.h>

namespace osgRoads::core
{

/// A lane of one section, driven in one direction.
struct LaneKey
{
    int road = -1, section = 0, lane = 0;
    bool isForward = true; ///< towards greater s

    bool operator==(const LaneKey&) const = default;
};

/// The lanes that cars use, and how one comes from one to another: along the road, over junctions, and
/// sideways. A lane with traffic in both directions is there twice.
/// Threads: any number may ask at the same time.
/// Source: ASAM OpenDRIVE 1.8, 10.3 (road linkage), 11.5 (lane linkage), 12 (junctions).
class LaneGraph
{
public:
    struct Edge
    {
        std::uint32_t to = 0;
        bool isLaneChange = false;
    };

    /// `network` is used while the graph is made, not later.
    explicit LaneGraph(const RoadNetwork& network);

    const std::vector<LaneKey>& lanes() const { return _lanes; }
    double lengthM(std::uint32_t lane) const { return _lengths[lane]; }

    /// Returns the lanes that one can go on to.
    const std::vector<Edge>& edges(std::uint32_t lane) const { return _edges[lane]; }

    /// Returns the index of a lane, or nothing: not there, or not for cars.
    std::optional<std::uint32_t> find(const LaneKey& key) const;

private:
    friend class LaneGraphBuilder;

    std::vector<LaneKey> _lanes;
    std::vector<double> _lengths;
    std::vector<std::vector<Edge>> _edges;
    std::vector<std::uint32_t> _firstOfRoad; ///< into _lanes, ascending; one more than roads
};

} // namespace osgRoads::core
