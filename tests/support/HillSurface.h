// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include <osgMultiTriangulation/core/surface/GridSurface.h>

#include "Random.h"

namespace testsupport
{

/// Rolling hills with rough ground on top, as a grid of points one step apart. Heights are multiples of 1/64
/// m.
inline osgMultiTriangulation::core::SurfaceMesh hillSurface(int columns, int rows, double roughnessM = 4.0)
{
    Random random(1);
    std::vector<float> heights;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
        {
            const double height = 60.0 * std::sin(column * 0.11) * std::cos(row * 0.07) +
                                  20.0 * std::sin(0.31 * column + 0.23 * row) + roughnessM * random.unit();
            heights.push_back(static_cast<float>(std::floor(height * 64.0) / 64.0));
        }
    return osgMultiTriangulation::core::gridSurface(columns, rows, heights);
}

} // namespace testsupport
