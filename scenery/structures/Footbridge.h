// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Heights.h>

#include "scenery/buildings/StandBuildings.h"
#include "scenery/structures/SquareBeams.h"
#include "scenery/structures/Structure.h"

namespace scenery
{

/// Adds the deck of a footbridge with its railings and piers, or a ramp, which is solid down to the ground.
/// Frame: the scene's. Needs heights.
void addFootbridge(const Structure& bridge, const foundation::HeightInPlan& ground, SquareBeams& beams);

inline constexpr double kFootDeckM = 0.5; ///< below the surface of a footbridge

} // namespace scenery
