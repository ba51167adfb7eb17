// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "scenery/models/Model.h"
#include "scenery/models/entities/EntityShape.h"

namespace scenery::models
{

/// Returns the colour of an aircraft's stripes, tips and fin, on white: one of six. As a display value.
glm::vec3 aircraftTrim(std::uint64_t seed);

/// Makes an aircraft that stands: one mesh of all its parts, controls in the middle, blades at rest, with the
/// usual size of its kind and a trim by the seed; light aircraft of even seeds have low wings. Pure.
/// Precondition: isAircraft(kind). Frame: that of Model.
Model makeStandingAircraft(EntityKind kind, std::uint64_t seed);

} // namespace scenery::models
