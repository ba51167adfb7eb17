// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include <osgPMObjects/core/tessellate/ConvexDecomposition.h>

#include "pmtool/polygons/PolygonSet.h"
#include "pmtool/polygons/WarpTexture.h"

namespace pmtool
{

/// How textured quads that are no parallelograms keep their texture, besides by grids (WarpedQuad.h).
enum class QuadTexture
{
    affine,     ///< they do not: it breaks along the diagonal
    preWarped,  ///< two triangles along corners 0 and 2, for a texture by warpTexture()
    projective, ///< the same triangles, with texture coordinates (u q, v q, q)
};

/// What polygons are cut into.
struct CutSettings
{
    osgPMObjects::core::OutlineOptions outline{};
    bool isConvex = false; ///< convex pieces instead of triangles; excludes the two lengths below
    osgPMObjects::core::ConvexMethod convexMethod = osgPMObjects::core::ConvexMethod::leastPieces;
    double longestEdge = 0.0;   ///< above 0: longer edges are halved; units of the positions
    double warpTolerance = 0.0; ///< above 0: textured quads become grids; units of the texture coordinates
    QuadTexture quadTexture = QuadTexture::affine; ///< of quads that are no grids; excludes longestEdge
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
    std::size_t grids = 0, refusedGrids = 0;       ///< textured quads; refused: not convex, or too many cells
    std::size_t warpedQuads = 0, refusedQuads = 0; ///< by QuadTexture; refused: not convex
};

/// The faces that polygons were cut into, counter-clockwise seen from the side of the polygon.
struct CutMesh
{
    std::vector<glm::dvec3> positions; ///< by vertex: those of the set, then new ones
    std::vector<glm::dvec2> texCoords; ///< by vertex, or empty
    std::vector<double> texDivisors;   ///< by vertex: q, or empty: all 1; texCoords are (u q, v q)
    std::vector<std::vector<std::uint32_t>> faces;
    std::vector<TexturedFace> texturedFaces; ///< for a pre-warped texture
    CutCounts counts;
};

/// Cuts every polygon of a set by tessellate(), decomposeConvex(), meshQuad() and meshUniformly(), as the
/// settings say. `file` stands in messages. Errors: those of these functions; the polygon's location is
/// named.
foundation::Result<CutMesh> cutPolygons(const PolygonSet& set, const CutSettings& settings,
                                        const std::string& file);

/// Returns a mesh as Wavefront .obj text: `v`, `vt` and `f` lines, with all digits. With divisors `vt` has
/// three numbers: u q, v q, q.
std::string objTextOf(const CutMesh& mesh);

} // namespace pmtool
