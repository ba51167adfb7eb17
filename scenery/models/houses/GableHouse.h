// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// Generates a detached house: one or two storeys below a steep gable roof, a chimney, dormers, a canopy over
/// the entrance. Seeds choose sizes, storeys, colours, windows and dormers. Pure. Surfaces: plaster or
/// bricks, details, roof tiles.
Model makeFamilyHouse(std::uint64_t seed);

} // namespace scenery::models
