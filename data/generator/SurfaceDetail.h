// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Grid.h"
#include "Noise.h"

namespace islandgen
{

/// Rock steps and gullies of 25 to 200 m, too small for the erosion to make: nothing where the ground is flatter
/// than 1 in 5, up to some metres on walls.
void roughenSlopes(Grid<float>& heightM, float cellM, Noise noise);

} // namespace islandgen
