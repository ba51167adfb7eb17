// SPDX-License-Identifier: Apache-2.0
#include <cassert>
#include <cmath>

#include <osgMultiTriangulation/core/surface/GridSurface.h>

namespace osgMultiTriangulation::core
{

bool isCutRising(float sw, float se, float nw, float ne, const CellCut& cut)
{
    using osgPMObjects::core::DiagonalRule;
    if (cut.rule == DiagonalRule::nearestHeights) return std::abs(sw - ne) <= std::abs(se - nw);
    osgPMObjects::core::Quad quad;
    quad[0].position = {0.0, 0.0, sw};
    quad[1].position = {cut.stepX, 0.0, se};
    quad[2].position = {cut.stepX, cut.stepY, ne};
    quad[3].position = {0.0, cut.stepY, nw};
    return diagonalCost(quad, 0, cut.rule) <= diagonalCost(quad, 1, cut.rule);
}

SurfaceMesh gridSurface(int columns, int rows, std::span<const float> heights, const CellCut& cut)
{
    assert(columns >= 2 && rows >= 2 && heights.size() == static_cast<std::size_t>(columns) * rows);
    SurfaceMesh mesh;
    mesh.points.reserve(heights.size());
    mesh.triangles.reserve(2 * heights.size());
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            mesh.points.push_back({column, row, heights[static_cast<std::size_t>(row) * columns + column]});
    for (int row = 0; row + 1 < rows; ++row)
        for (int column = 0; column + 1 < columns; ++column)
        {
            const auto sw = static_cast<std::uint32_t>(row * columns + column);
            const std::uint32_t se = sw + 1, nw = sw + columns, ne = nw + 1;
            const bool rises = isCutRising(heights[sw], heights[se], heights[nw], heights[ne], cut);
            mesh.triangles.push_back(rises ? Triangle{sw, se, ne} : Triangle{sw, se, nw});
            mesh.triangles.push_back(rises ? Triangle{sw, ne, nw} : Triangle{se, ne, nw});
        }
    return mesh;
}

} // namespace osgMultiTriangulation::core
