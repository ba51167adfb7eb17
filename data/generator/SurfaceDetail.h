// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Grid.h"
#include "Noise.h"

namespace islandgen
{

/// Adds rock steps and gullies of 25 to 200 m, which are too small for the erosion's grid: nothing where the
/// ground is flatter than 1 in 5, up to some metres on steep walls.
void roughenSlopes(Grid<float>& heightM, float cellM, Noise noise);

} // namespace islandgen
