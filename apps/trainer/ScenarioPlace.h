// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/geodesy/LocalFrame.h"
#include "simulation/scenario/Scenario.h"

namespace trainer
{

/// Returns the first place on earth in Init, at height 0: the origin of a scene without terrain. Absent: Init names none.
std::optional<simulation::Geodetic> placeOnEarth(const simulation::Scenario& scenario);

/// Returns the least z of the world positions that Init puts entities at, metres; 0 without any.
double lowestStartM(const simulation::Scenario& scenario);

} // namespace trainer
