// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// A barn of planks on a stone plinth with double doors in its long side and its gable. Pure. Surfaces: planks, details, roof tiles.
Model makeBarn(std::uint64_t seed);

/// An industrial hall of sheet metal: gates, bands of windows below the eaves, skylights and a ventilator on the flat-pitched
/// roof. Pure. Surfaces: sheet metal, details, roof metal.
Model makeHall(std::uint64_t seed);

} // namespace scenery::models
