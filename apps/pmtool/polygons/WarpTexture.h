// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <glm/vec4.hpp>

#include <osgPMObjects/core/tessellate/WarpedQuad.h>

namespace pmtool
{

/// A texture in memory: red, green, blue and alpha, 0 … 1, row by row; the first texel is that at texture
/// coordinates (0, 0). It repeats beyond 0 … 1.
struct Texels
{
    std::uint32_t width = 0, height = 0;
    std::vector<glm::vec4> colours;
};

/// A triangle that shows a part of a texture: of a quad, along whose bilinear patch the texture is to lie, or
/// of another face, where it lies as it is.
struct TexturedFace
{
    osgPMObjects::core::TexturedQuad quad; ///< of another face the first three corners
    bool isQuad = false;
    std::string location; ///< where it stands in its file, for messages
};

/// Makes the pre-warped texture of quads: drawn as two triangles along their corners 0 and 2, with their
/// texture coordinates, they show `texture` along their bilinear patches. Each texel whose centre lies in a
/// quad takes the colour of its source (preWarpedTexCoord()), interpolated; the others stay. Along borders of
/// quads the texture stays as it is, so neighbours still meet.
/// Errors: two faces show the same texels, and want sources farther apart than half a texel; a face shows
/// more than 2^28 texels, or coordinates that are no numbers.
/// Source: Jin, *Polygon Techniques*, "shading".
foundation::Result<Texels> warpTexture(const Texels& texture, std::span<const TexturedFace> faces);

} // namespace pmtool
