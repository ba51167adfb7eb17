// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "../star/Star.h"
#include "MirrorTwins.h"

namespace osgPMObjects::core
{

/// Whether a face that a collapse and its mirror image both change would turn over after both. `star`: around
/// the position that merges with `other` at `at`.
bool foldsWithTwin(const MirrorTwins& twins, std::span<const glm::dvec3> positions, const Star& star,
                   std::uint32_t other, const glm::dvec3& at);

} // namespace osgPMObjects::core
