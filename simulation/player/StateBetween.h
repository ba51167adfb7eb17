// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/state/EntityState.h"

namespace simulation
{

/// The state of an entity between those of two steps that follow each other. `share`: 0 at `from`, 1 at `to`.
/// `stepS`: the time between them. Positions go straight, angles the shorter way round. Where it was put
/// elsewhere, came or went, and for all that is switched, it is `to`.
EntityState stateBetween(const EntityState& from, const EntityState& to, double share, double stepS);

} // namespace simulation
