// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgPMObjects/core/tessellate/EarClipping.h>

namespace osgPMObjects::core
{

/// A textured quad whose texture may be stretched unevenly. The texture is meant to follow the bilinear patch
/// of the corners: for all s and t in 0 … 1, the position at (s, t) has the texture coordinates at (s, t).
/// Two triangles cannot do this, for each maps the texture affinely, in a different way.
/// Source: Jin, *Polygon Techniques*, "shading": the problem, and the solutions finer meshing, a pre-warped
/// texture, projective and bilinear mapping.
struct TexturedQuad
{
    std::array<glm::dvec3, 4> positions; ///< in order around the quad
    std::array<glm::dvec2, 4> texCoords;
};

glm::dvec3 positionAt(const TexturedQuad& quad, const glm::dvec2& shares);
glm::dvec2 texCoordAt(const TexturedQuad& quad, const glm::dvec2& shares);

/// The first solution: a grid of cells whose points have the patch's positions and texture coordinates.
struct QuadGrid
{
    std::uint32_t cells = 1; ///< along each side
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec2> texCoords;
    std::vector<Triangle> triangles;
};

/// Makes a grid with enough cells to keep the texture within `tolerance` (in texture coordinates) of its
/// intended position. A cell's error is at most a quarter of its deviation from a parallelogram, in position
/// and texture; halving the cells divides it by four.
/// Errors: a tolerance that is not above zero; more than `mostCells` along a side, as for a quad that is not
/// convex.
foundation::Result<QuadGrid> meshQuad(const TexturedQuad& quad, double tolerance,
                                      std::uint32_t mostCells = 256);

/// Computes a texel's source for the second solution, a pre-warped texture: the coordinate in the given
/// texture whose colour the warped texture needs at a point. The warped texture has the same texture
/// coordinates. `weights`: of corners 0 … 3 at the point; it lies in a triangle of diagonal 0–2, so the
/// weight of corner 1 or 3 is zero; the sum is 1. If the quad is not flat, the point is taken to the patch
/// along the average normal. Returns nothing if no point of the patch lies there (the quad is not convex).
std::optional<glm::dvec2> preWarpedTexCoord(const TexturedQuad& quad, const std::array<double, 4>& weights);

/// Computes the third solution, for cards that divide by the third texture coordinate: (u q, v q, q) for each
/// corner, the projective map of a flat convex quad to that of its texture coordinates. Straight lines of the
/// texture stay straight, unlike in the bilinear patch. All q are equal where an affine map does. Returns
/// nothing if the diagonals do not meet inside the quad, or not inside that of its texture coordinates.
std::optional<std::array<glm::dvec3, 4>> projectiveTexCoords(const TexturedQuad& quad);

} // namespace osgPMObjects::core
