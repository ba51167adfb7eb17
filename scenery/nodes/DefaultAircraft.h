// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/state/EntityState.h"

namespace scenery
{

/// Returns what an aircraft shows that does not tell of its parts, one that follows a trajectory: its
/// propeller turns while it moves, surfaces and wheels stand as they are built, the lights are on that the
/// rules ask for.
simulation::AircraftParts defaultAircraftParts(const simulation::EntityState& state, bool isDark);

} // namespace scenery
