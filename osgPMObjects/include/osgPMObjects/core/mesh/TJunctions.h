// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/mesh/EdgeTable.h>

namespace osgPMObjects::core
{

/// A vertex inside an edge that does not end at it.
struct TJunction
{
    std::uint32_t edge = 0;   ///< in the EdgeTable
    std::uint32_t vertex = 0; ///< a position
    double along = 0.0; ///< foot of the vertex as a share of the edge, from its lower position to the higher
    double distance = 0.0; ///< of the vertex from the edge
};

/// The T-junctions that a search has found.
struct FoundTJunctions
{
    std::vector<TJunction> all;
    bool isCutShort = false; ///< the limits of findTJunctions() were reached: there may be more
};

/// The edges that count as open: a crack may show there.
enum class OpenEdges
{
    boundary,   ///< with one face: the usual count of T-junctions
    notMatched, ///< with one face or more than two: also edges that a split of non-manifold edges will open
};

/// Finds the T-junctions of a mesh: vertices of open edges that are within `tolerance` of another open edge,
/// with their foot between 0.0001 and 0.9999 of it. The published figures of test models use a tolerance of
/// 1e-5 of the diagonal.
/// `among`: by position, 0 for positions to ignore, with the edges that end there; empty: none is ignored.
/// Where the tolerance is larger than the details of the mesh, every vertex may be in a junction with every
/// edge: then the search stops at four junctions for each open edge and vertex (and 65 536), or some thousand
/// comparisons for each open edge.
/// Units: as the positions. Order: by edge, then along it. Cost: about linear; parallel. Memory: at most 130
/// B for each open edge and vertex and thread.
/// Source: Jin, *Polygon Techniques* (lecture after Akenine-Möller & Haines, *Real-Time Rendering*, 2002,
/// chapter 11), Edge cracking and T-vertices.
FoundTJunctions findTJunctions(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                               const EdgeTable& edges, double tolerance, OpenEdges open,
                               std::span<const std::uint8_t> among = {});

/// Counts the vertices that are in some T-junction. Memory: linear, however many junctions there are. Cost:
/// about linear, and limited in the same way: then it counts the vertices that were found.
std::size_t countTVertices(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                           const EdgeTable& edges, double tolerance, OpenEdges open);

} // namespace osgPMObjects::core
