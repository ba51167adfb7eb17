// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// A detached family house: one or two storeys below a steep saddle roof, chimney, dormers, a canopy over the entrance.
/// Seeds choose measures, storeys, colours, windows, dormers. Pure. Surfaces: plaster or bricks, details, roof tiles.
Model makeFamilyHouse(std::uint64_t seed);

} // namespace scenery::models
