// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include <osgPMObjects/core/tessellate/ConvexDecomposition.h>

#include "pmtool/polygons/PolygonSet.h"

namespace pmtool
{

/// What polygons are cut into.
struct CutSettings
{
    osgPMObjects::core::OutlineOptions outline{};
    bool isConvex = false; ///< convex pieces instead of triangles; excludes the two lengths below
    osgPMObjects::core::ConvexMethod convexMethod = osgPMObjects::core::ConvexMethod::leastPieces;
    double longestEdge = 0.0;   ///< above 0: longer edges are halved; units of the positions
    double warpTolerance = 0.0; ///< above 0: textured quads become grids; units of the texture coordinates
};

/// Counts over all polygons.
struct CutCounts
{
    std::size_t polygons = 0, corners = 0, holes = 0;
    std::size_t inserted = 0;      ///< vertices made where edges cross
    std::size_t crossings = 0;     ///< pairs of edges; not counted of convex pieces
    std::size_t unusedCorners = 0; ///< of no triangle; not counted of convex pieces
    std::size_t bridges = 0;       ///< holes joined to what is around them; not counted of convex pieces
    std::size_t leastPieces = 0;   ///< polygons whose number of convex pieces is proved least
    std::size_t grids = 0, refusedGrids = 0; ///< textured quads; refused: not convex, or too many cells
};

/// The faces that polygons were cut into, counter-clockwise seen from the side of the polygon.
struct CutMesh
{
    std::vector<glm::dvec3> positions; ///< by vertex: those of the set, then new ones
    std::vector<glm::dvec2> texCoords; ///< by vertex, or empty
    std::vector<std::vector<std::uint32_t>> faces;
    CutCounts counts;
};

/// Cuts every polygon of a set by tessellate(), decomposeConvex(), meshQuad() and meshUniformly(), as the
/// settings say. `file` stands in messages. Errors: those of these functions; the polygon's location is
/// named.
foundation::Result<CutMesh> cutPolygons(const PolygonSet& set, const CutSettings& settings,
                                        const std::string& file);

/// Returns a mesh as Wavefront .obj text: `v`, `vt` and `f` lines, with all digits.
std::string objTextOf(const CutMesh& mesh);

} // namespace pmtool
