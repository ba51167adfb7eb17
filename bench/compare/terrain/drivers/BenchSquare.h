// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/HeightField.h>

namespace terraintool
{

/// Which square of a raster is measured.
struct SquareChoice
{
    std::vector<int> crop{};     ///< side in samples; column and row of its north-west sample
    std::optional<double> cellM; ///< sample distance instead of the file's
};

/// Returns the square of samples that was asked for, from the north-west; else the largest of 2^n+1 samples
/// in the middle. Errors: it is no part of the raster, or too small; `file` is their place.
foundation::Result<osgTerrainROAM::core::HeightField>
squareOf(const osgTerrainROAM::core::HeightField& all, const SquareChoice& choice, const std::string& file);

} // namespace terraintool
