// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Grid.h"
#include "Noise.h"

namespace islandgen
{

/// Value at a fractional place of the grid; C1 smooth (Catmull-Rom), edges repeated.
float interpolated(const Grid<float>& grid, float column, float row);

/// The same square on a grid of another side; the corners keep their places.
Grid<float> resampled(const Grid<float>& grid, int side);

/// As resampled, with every place moved by smooth noise. A continuous move keeps valleys connected and
/// bends what ran along the grid's eight directions.
/// Units: wavelength and amplitude in cells of the result.
Grid<float> resampledBent(const Grid<float>& grid, int side, Noise noise, float wavelength, float amplitude);

} // namespace islandgen
