// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// What insertTVertices() did.
struct TVertices
{
    std::size_t inserted = 0; ///< vertices put into the edges of faces, each face counted
    std::size_t stitched = 0; ///< vertices that became one with the end of an edge they lay beside
    std::size_t slivers =
        0; ///< open faces lower than the tolerance, whose own corner is the T-vertex, or thin ones: removed
    std::size_t moved =
        0; ///< vertices moved half-way to the edge that they were farther from than half the tolerance

    bool isNothing() const { return inserted + stitched + slivers == 0; }
};

/// What passes hand on to the next.
struct TVertexState
{
    double tolerance = 0.0;  ///< how far from an edge a vertex counts as lying on it; units: as the positions
    double thinHeight = 0.0; ///< faces with a T-vertex that are no higher than this are removed, not cut
    std::vector<double> drift{};          ///< how far each position has moved so far
    std::vector<std::uint8_t> among{};    ///< by position, 0 for those that are left alone; empty: none are
    std::vector<std::uint32_t> waiting{}; ///< positions of the T-junctions that the latest pass put off
};

/// One pass against T-junctions (see findTJunctions()). Vertices whose foot is nearer than twice the tolerance to an end of the
/// edge are stitched to that end, at the middle of the two; a pass that stitches does nothing else. Otherwise each open edge is
/// split at the vertices that lie on it, and its faces with it; new corners get attributes interpolated along the edge, so that
/// shading and texture stay. An edge that is bent so may become one that others lie on: call it again until it did nothing.
/// No position moves farther than the tolerance in all passes, and what would have to, stays a T-junction.
/// Source: Akenine-Möller and Haines, "Real-Time Rendering", ch. 11, Edge cracking and T-vertices: the vertex is put into the
/// neighbouring polygon, which is then cut into triangles; here by halves, from the opposite corner.
TVertices insertTVertices(Mesh& mesh, TVertexState& state);

} // namespace osgPMObjects::core
