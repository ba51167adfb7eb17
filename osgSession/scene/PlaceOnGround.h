// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include "simulation/player/ScenarioPlayer.h"

namespace trainer
{

struct SceneTerrain;

/// Checks that an entity begins where the ground is: within its data, an aircraft within 20 km of them, and
/// nothing 10 m and more below the surface. From elsewhere a picture shows sky without ground, or nothing.
/// Nothing is checked of an entity that is added later, and in a scene without elevation. `scenario`: the
/// file that an error names.
/// Errors: entity, place, extent of the ground or depth below it, and the remedy.
foundation::Outcome checkPlaceOnGround(const simulation::ScenarioPlayer& player, std::size_t entity,
                                       const SceneTerrain& terrain, const std::string& scenario);

} // namespace trainer
