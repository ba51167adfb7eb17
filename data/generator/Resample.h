// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Grid.h"
#include "Noise.h"

namespace islandgen
{

/// Interpolates the grid between cells; C1 smooth (Catmull-Rom), edges repeated.
float interpolated(const Grid<float>& grid, float column, float row);

/// Resamples the square to a grid of another side; the corners stay where they are.
Grid<float> resampled(const Grid<float>& grid, int side);

/// Resamples with every position moved by smooth noise. The move is continuous: valleys stay connected, and
/// valleys along the grid's eight directions become curved.
/// Units: wavelength and amplitude in cells of the result.
Grid<float> resampledBent(const Grid<float>& grid, int side, Noise noise, float wavelength, float amplitude);

} // namespace islandgen
