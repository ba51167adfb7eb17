// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "simulation/geodesy/LocalFrame.h"
#include "simulation/scenario/Scenario.h"

namespace trainer
{

/// Returns the first place on earth in Init, at height 0: the origin of a scene without terrain. Absent: Init
/// names none.
std::optional<simulation::Geodetic> placeOnEarth(const simulation::Scenario& scenario);

/// Returns x and y of the first world position that Init puts an entity at, and the least z of all of them,
/// metres; a z that is left out counts as 0. Absent: Init names none.
std::optional<glm::dvec3> startInWorld(const simulation::Scenario& scenario);

} // namespace trainer
