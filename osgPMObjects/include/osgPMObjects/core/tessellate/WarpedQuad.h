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

/// A quad with a texture that its corners stretch unevenly. The texture is meant to follow the bilinear patch: what lies at
/// shares (s, t) between the corners' positions lies there between their texture coordinates. Two triangles can only map
/// it affinely, each in a way of its own.
/// Source: paper 002, "shading": a triangle's three texture coordinates map affinely; the ways out are finer meshing, a
/// texture warped beforehand, projective and bilinear mapping.
struct TexturedQuad
{
    std::array<glm::dvec3, 4> positions; ///< in turn
    std::array<glm::dvec2, 4> texCoords;
};

glm::dvec3 positionAt(const TexturedQuad& quad, const glm::dvec2& shares);
glm::dvec2 texCoordAt(const TexturedQuad& quad, const glm::dvec2& shares);

/// The first way: a grid of so many cells along each side, with the patch's positions and texture coordinates at its points.
struct QuadGrid
{
    std::uint32_t cells = 1; ///< along each side
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec2> texCoords;
    std::vector<Triangle> triangles;
};

/// Enough cells to hold the texture within `tolerance` of where it belongs, in units of its coordinates. A cell's triangles
/// are off by at most a quarter of how far its corners are from a parallelogram, in position and in texture, which falls to
/// a quarter with each halving of the cells.
/// Errors: no tolerance above zero; more than `mostCells` along a side, as for a quad that is not convex.
foundation::Result<QuadGrid> meshQuad(const TexturedQuad& quad, double tolerance,
                                      std::uint32_t mostCells = 256);

/// The second way, a texture warped beforehand: where to look in the given texture for what the warped one shall have at
/// the place that lies at `weights` (of corners 0, 1, 2 and 3, of which 1 or 3 is zero; sum 1) of the two triangles that
/// the diagonal 0–2 makes. The warped texture is drawn with the same texture coordinates.
/// Frame: for a warped quad the place in space is taken to the patch along the average normal.
/// Errors: nothing, where no place of the patch lies there (the quad is not convex).
std::optional<glm::dvec2> preWarpedTexCoord(const TexturedQuad& quad, const std::array<double, 4>& weights);

/// The third way, for cards that divide by the third texture coordinate: (u q, v q, q) for each corner, the projective map of
/// a flat convex quad. Straight lines of the texture stay straight, unlike in the bilinear patch.
/// Errors: nothing, when the diagonals do not meet inside.
std::optional<std::array<glm::dvec3, 4>> projectiveTexCoords(const TexturedQuad& quad);

} // namespace osgPMObjects::core
