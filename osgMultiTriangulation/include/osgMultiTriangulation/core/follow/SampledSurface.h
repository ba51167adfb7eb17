// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/file/MtFile.h>

namespace osgMultiTriangulation::core
{

/// Heights of a surface at the points of a grid over its extent.
struct SampledSurface
{
    int columns = 2, rows = 2;
    double spacingX = 1.0, spacingY = 1.0; ///< in units of the plan
    std::vector<float>
        heights; ///< row by row from the south; where there is no surface that of a sample near by
    std::vector<std::uint8_t> isThere;   ///< by sample: whether the surface is there
    float lowest = 0.0f, highest = 0.0f; ///< of the surface, its points between the samples included
};

/// Samples the surface of a file: at its lattice, where that has no more than `mostSide` points a side, else
/// evenly. Trees are read one after the other; of large files trees at the end are read in part, by about
/// four points a sample.
/// Errors: the main part is damaged. Other damaged trees are coarse here.
foundation::Result<SampledSurface> sampleSurface(const MtFile& file, int mostSide = 1025);

} // namespace osgMultiTriangulation::core
