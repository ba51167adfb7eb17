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
    int samplesPerSide = 2; ///< of a texel, 1 to 8: their mean is what it shows
    double reach = 0.0;     ///< how far the surfaces may be apart, in units; 0: found out
};

/// What the full model looks like at a point of one of its faces (`weights` of its corners), without light: red, green, blue and
/// alpha, 0 to 1, as a face `simplifiedFace` of the simplified mesh has to show it. Called by several threads at once.
using ColourAt =
    std::function<glm::vec4(std::uint32_t fullFace, const glm::dvec3& weights, std::uint32_t simplifiedFace)>;

using Rgba = std::array<std::uint8_t, 4>;
using Rgb = std::array<std::uint8_t, 3>;

/// Pictures of a full model over the charts of a simplified one. Rows from below.
/// Frame: normals are in the mesh's own (object space), n = 2·c/255 − 1: nothing has to be known about tangents, and nothing is
/// lost where they turn; a model that bends would need another frame.
/// Normals are means, of a face's corners and over the texel, and as short as these come out: then n·l is the mean of the light
/// that the corners get, as fixed function draws it, and so it is in smaller copies of the map.
struct BakedMaps
{
    int sizePx = 0;
    std::vector<Rgba> colours;
    std::vector<Rgb> normals;
    std::size_t coveredTexels = 0;   ///< with their centre in a face
    std::size_t lookedUpTexels = 0;  ///< covered, or just beside
    std::size_t unmatchedTexels = 0; ///< of those looked up: nothing of the full model agrees
    double reach = 0.0;              ///< that was taken. Units: the meshes'
};

/// Looks up for every texel of every chart, and those that filtering reads beside it, what the full surface shows where the
/// simplified one stands for it (SurfaceMatch.h): its colour, and the normal that it is lit by. A texel without a match that agrees keeps
/// the simplified surface's normal. All other texels get the mean of those around, so that smaller copies of
/// the picture stay clean.
/// `simplified`: made of `full`, parts and materials have the same numbers; `atlas`: of its charts.
/// Memory: 80 B a face of the full mesh, 22 B a texel. Cost: some 2 µs of the processor a sample; parallel.
BakedMaps bakeMaps(const Mesh& full, const Mesh& simplified, const Atlas& atlas, const ColourAt& colourAt,
                   const BakeSettings& settings = {});

} // namespace osgPMObjects::core
