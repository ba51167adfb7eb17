// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/mesh/EdgeTable.h>

namespace osgPMObjects::core
{

/// A vertex that lies inside an edge of which it is no end.
struct TJunction
{
    std::uint32_t edge = 0;   ///< in the EdgeTable
    std::uint32_t vertex = 0; ///< a position
    double along = 0.0;       ///< of its foot, as a share of the edge from its lower position to the higher
    double distance = 0.0;    ///< from the edge
};

/// Which edges are open, that is, could show a crack.
enum class OpenEdges
{
    boundary,   ///< with one face: as T-junctions are counted
    notMatched, ///< with one face or more than two: also what a split of crowded edges will leave open
};

/// The T-junctions of a mesh: vertices of open edges, no farther than `tolerance` from another open edge, with their foot
/// between the ten-thousandth and the 0.9999th part of it.
/// The definition is the one that the figures of published test models are counted by: distance 1e-5 of the diagonal.
/// `among`: by position, 0 for those that are not looked at, nor edges that end there; empty: all are.
/// Units: as the positions. Order: by edge, then along it. Cost: about linear; parallel.
/// Source: Akenine-Möller and Haines, "Real-Time Rendering", ch. 11, Edge cracking and T-vertices.
std::vector<TJunction> findTJunctions(std::span<const glm::dvec3> positions,
                                      std::span<const Triangle> triangles, const EdgeTable& edges,
                                      double tolerance, OpenEdges open,
                                      std::span<const std::uint8_t> among = {});

/// How many vertices are in some T-junction.
std::size_t countVertices(std::span<const TJunction> junctions);

} // namespace osgPMObjects::core
