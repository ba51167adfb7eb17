// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace osgPMObjects::core
{

/// Finds for each position the nearest one in another part, within `distance`; ~0 where there is none. `partOf`: by position,
/// ~0 for unused ones. Cost: about linear when few are within the distance.
/// Source: Garland and Heckbert, *Surface simplification using quadric error metrics* (1997), section 3.2 (pairs within a
/// threshold).
/// Differs: one pair a position, between parts only.
std::vector<std::uint32_t> nearestOfOtherParts(std::span<const glm::dvec3> positions,
                                               std::span<const std::uint32_t> partOf, double distance);

} // namespace osgPMObjects::core
