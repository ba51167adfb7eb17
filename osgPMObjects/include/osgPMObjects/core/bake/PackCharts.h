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
    int sizePx = 1024; ///< of the atlas' sides: a power of two, 16 to 8192
    int gutterPx = 3;  ///< left free around each chart: twice that lies between two
};

/// Charts side by side in a square picture, all at the same scale.
/// Invariant: no texel is nearer than the gutter to two charts.
struct Atlas
{
    int sizePx = 0;
    double texelsPerUnit = 0.0;
    Charts charts;                  ///< turned: their axes are the atlas'
    std::vector<glm::dvec2> origin; ///< by chart: where its plane's origin lies. Units: texels

    /// Where a face's chart shows a position. Units: texels, from the lower left corner; a texel's centre is at a half.
    glm::dvec2 texelOf(std::uint32_t face, const glm::dvec3& position) const
    {
        const std::uint32_t chart = charts.chartOfFace[face];
        return origin[chart] + texelsPerUnit * charts.charts[chart].flat(position);
    }
};

/// Packs charts as large as they fit: turned upright into their smallest rectangle, the highest first, each let down where the
/// skyline and its own underside leave it lowest. The scale is the largest of some twenty tried.
/// Errors: sizes out of range; more charts than fit at one texel each.
/// Cost: size × widths of all charts, times the scales tried; 300 charts in 1024² in some 30 ms.
/// Source: Lévy, Petitjean, Ray and Maillot, "Least squares conformal maps for automatic texture atlas generation" (2002), §4
/// (charts as Tetris pieces with horizons); we take the lowest place, theirs the one with the least lost space.
foundation::Result<Atlas> packCharts(const Mesh& mesh, Charts charts, const PackSettings& settings = {});

} // namespace osgPMObjects::core
