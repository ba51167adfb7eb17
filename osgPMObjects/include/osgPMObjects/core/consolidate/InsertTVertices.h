// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Report of insertTVertices().
struct TVertices
{
    std::size_t inserted = 0; ///< vertices inserted into edges of faces, once for each face
    std::size_t stitched = 0; ///< vertices merged with the near end of an edge
    /// removed: open faces whose own corner is the T-vertex and lower than the tolerance, or thin ones
    std::size_t slivers = 0;
    std::size_t moved =
        0; ///< vertices moved half-way to their edge, since they were farther than half the tolerance

    bool isNothing() const { return inserted + stitched + slivers == 0; }
};

/// State that successive passes share.
struct TVertexState
{
    double tolerance = 0.0;  ///< the largest distance of a T-vertex from its edge; units: as the positions
    double thinHeight = 0.0; ///< faces with a T-vertex up to this height are removed, not cut
    std::size_t mostNewFaces =
        std::numeric_limits<std::size_t>::max(); ///< limit of faces that may still be added
    bool isAtLimit = false; ///< a pass would have exceeded it, or its search was cut short
    /// by position: the box of the places where those merged into it were
    std::vector<Extent> homes{};
    std::vector<std::uint8_t> among{};    ///< by position: 0 where it is ignored; empty: none is
    std::vector<std::uint32_t> waiting{}; ///< positions of T-junctions that the latest pass postponed

    /// Notes where the positions are that have no home yet.
    void noteHomes(std::span<const glm::dvec3> positions)
    {
        for (std::size_t p = homes.size(); p < positions.size(); ++p)
            homes.push_back(extentOf(positions.subspan(p, 1)));
    }
};

/// Makes one pass against T-junctions (see findTJunctions()). A vertex with its foot within twice the
/// tolerance of an end of the edge is merged with that end, at their middle; a pass that merges does nothing
/// else. Otherwise each open edge is split at the vertices on it, with its faces. New corners get attributes
/// interpolated along the edge, so shading and texture do not change. An edge that is bent in this way may
/// create new T-junctions: call the function until it changes nothing. No position ends farther than the
/// tolerance from where it was, merged ones included; a vertex that would remains a T-junction. Where
/// `thinHeight` is set, two may merge up to four tolerances from there. A pass that would exceed the
/// limit of new faces, or whose search is cut short, inserts nothing: the tolerance is then larger than the
/// details of the mesh.
/// Source: Jin, *Polygon Techniques* (lecture after Akenine-Möller & Haines, *Real-Time Rendering*, 2002,
/// chapter 11), Edge cracking and T-vertices: the vertex is inserted into the neighbouring polygon, which is
/// then triangulated; here by bisection.
TVertices insertTVertices(Mesh& mesh, TVertexState& state);

} // namespace osgPMObjects::core
