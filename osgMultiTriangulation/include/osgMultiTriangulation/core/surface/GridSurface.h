// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>
#include <osgPMObjects/core/tessellate/QuadDiagonal.h>

namespace osgMultiTriangulation::core
{

/// Along which diagonal the cells of a grid are cut into two triangles.
struct CellCut
{
    osgPMObjects::core::DiagonalRule rule =
        osgPMObjects::core::DiagonalRule::nearestHeights; ///< isForHeightFields()
    double stepX = 1.0, stepY = 1.0;                      ///< between samples, in units of the heights
};

/// Whether a cell is cut from the south-west to the north-east; so it is when both diagonals are alike to the
/// rule.
/// Source: Jin, *Polygon Techniques*, shading: four rules for height fields.
bool isCutRising(float sw, float se, float nw, float ne, const CellCut& cut);

/// Returns a grid of heights as a mesh with two triangles a cell; sample (column, row) is the point (column,
/// row).
/// `heights`: row-major, the southernmost row first. Columns and rows: at least 2.
SurfaceMesh gridSurface(int columns, int rows, std::span<const float> heights, const CellCut& cut = {});

} // namespace osgMultiTriangulation::core
