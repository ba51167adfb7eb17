// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// Whether a cell is cut from the south-west to the north-east: along the diagonal whose ends differ less in
/// height.
inline bool isCutRising(float sw, float se, float nw, float ne)
{
    return std::abs(sw - ne) <= std::abs(se - nw);
}

/// Returns a grid of heights as a mesh with two triangles a cell; sample (column, row) is the point (column,
/// row). Each cell is cut along the diagonal whose ends differ less in height, from the south-west when both
/// differ alike.
/// `heights`: row-major, the southernmost row first. Columns and rows: at least 2.
SurfaceMesh gridSurface(int columns, int rows, std::span<const float> heights);

} // namespace osgMultiTriangulation::core
