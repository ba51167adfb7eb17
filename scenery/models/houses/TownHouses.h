// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// A row of two to four town houses wall to wall, three to five storeys each, shops on the ground floor, cornices, dormers,
/// chimneys on the party walls. Seeds choose all of that and the colours. Pure. Surfaces: plaster, details, roof tiles.
Model makeTownHouses(std::uint64_t seed);

} // namespace scenery::models
