// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <foundation/Result.h>
#include <glm/vec2.hpp>

#include <osgPMObjects/core/bake/Charts.h>
#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

struct PackSettings
{
    int sizePx = 1024; ///< side of the atlas: a power of two, 16 to 8192
    int gutterPx = 3;  ///< free texels around each chart: twice as many between two
};

/// An atlas: charts side by side in a square image, all at the same scale.
/// Invariant: no texel is within the gutter of two charts.
struct Atlas
{
    int sizePx = 0;
    double texelsPerUnit = 0.0;
    Charts charts;                  ///< rotated: their axes are those of the atlas
    std::vector<glm::dvec2> origin; ///< by chart: the origin of its plane. Units: texels

    /// Maps a position of a face into the atlas. Units: texels, from the lower left corner; texel centres at
    /// 0.5.
    glm::dvec2 texelOf(std::uint32_t face, const glm::dvec3& position) const
    {
        const std::uint32_t chart = charts.chartOfFace[face];
        return origin[chart] + texelsPerUnit * charts.charts[chart].flat(position);
    }
};

/// Packs charts into an atlas, as large as they fit. Each is rotated into its smallest rectangle and stands
/// upright; the highest are placed first, each where the skyline and its own lower outline let it lie lowest.
/// Some twenty scales are tried, the largest is taken.
/// Errors: sizes out of range; more charts than fit at one texel each.
/// Cost: size × widths of all charts, times the scales tried; 300 charts in 1024² in some 30 ms.
/// Source: Lévy, Petitjean, Ray and Maillot, *Least squares conformal maps for automatic texture atlas
/// generation* (2002), section 4 (charts as Tetris pieces with horizons). Differs: the lowest position, not
/// the one with the least lost space.
foundation::Result<Atlas> packCharts(const Mesh& mesh, Charts charts, const PackSettings& settings = {});

} // namespace osgPMObjects::core
