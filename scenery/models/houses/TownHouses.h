// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// Generates a row of two to four terraced town houses of three to five storeys, with shops on the ground
/// floor, cornices, dormers, and chimneys on the party walls. Seeds choose all of that and the colours. Pure.
/// Surfaces: plaster, details, roof tiles.
Model makeTownHouses(std::uint64_t seed);

} // namespace scenery::models
