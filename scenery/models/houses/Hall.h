// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// Generates a barn of planks on a stone plinth with double doors in a long side and a gable. Pure. Surfaces:
/// planks, details, roof tiles.
Model makeBarn(std::uint64_t seed);

/// Generates an industrial hall of sheet metal: gates, bands of windows below the eaves, skylights and a
/// ventilator on a roof of low pitch. Pure. Surfaces: sheet metal, details, roof metal.
Model makeHall(std::uint64_t seed);

} // namespace scenery::models
