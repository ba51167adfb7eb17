// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <osgPMObjects/core/bake/PackCharts.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

struct BakeSettings
{
    int samplesPerSide = 2; ///< samples per texel side, 1 to 8; a texel is their mean
    double reach =
        0.0; ///< the largest distance of corresponding points, in units of the meshes; 0: estimated
};

/// Returns the unlit colour of the full model at a point of a face: red, green, blue, alpha, 0 to 1.
/// `weights`: barycentric coordinates; `simplifiedFace`: the face that will show it. Called by several
/// threads at once.
using ColourAt =
    std::function<glm::vec4(std::uint32_t fullFace, const glm::dvec3& weights, std::uint32_t simplifiedFace)>;

using Rgba = std::array<std::uint8_t, 4>;
using Rgb = std::array<std::uint8_t, 3>;

/// Colour and normal maps of a full model, over the charts of a simplified one. Rows from the bottom.
/// Frame: normals are in object space, n = 2·c/255 − 1. They need no tangents, and lose nothing where
/// tangents change; a deformable model would need another frame. Normals are means over a face's corners and
/// a texel, not normalised: n·l is then the mean of the corners' light, as with per-vertex lighting, also in
/// mipmaps.
struct BakedMaps
{
    int sizePx = 0;
    std::vector<Rgba> colours;
    std::vector<Rgb> normals;
    std::size_t coveredTexels = 0;   ///< texels with their centre in a face
    std::size_t lookedUpTexels = 0;  ///< texels sampled: covered, or next to one
    std::size_t unmatchedTexels = 0; ///< of these, without a match in the full model
    double reach = 0.0;              ///< the reach used. Units: as the meshes
};

/// Samples the full surface for every texel of every chart, and for the texels beside it that filtering
/// reads: colour and normal at the corresponding point (SurfaceMatch.h). A texel without a match keeps the
/// normal of the simplified surface. All other texels get the mean of their surroundings, so that mipmaps
/// have no seams.
/// `simplified`: made of `full`, with the same numbers of parts and materials; `atlas`: of its charts.
/// Memory: 80 B a face of the full mesh, 22 B a texel. Cost: some 2 µs of processor time a sample; parallel.
/// Source: Cignoni, Montani, Rocchini and Scopigno, *A general method for preserving attribute values on
/// simplified meshes* (1998).
BakedMaps bakeMaps(const Mesh& full, const Mesh& simplified, const Atlas& atlas, const ColourAt& colourAt,
                   const BakeSettings& settings = {});

} // namespace osgPMObjects::core
