// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace osgPMObjects::core
{

/// For each position the nearest one that belongs to another part, no farther than `distance`; ~0 where there is none. `partOf`: by
/// position, ~0 for those that no face uses. Cost: about linear where few lie within the distance.
/// Source: Garland and Heckbert (1997), §3.2 (pairs within a threshold); one pair a position, between parts only.
std::vector<std::uint32_t> nearestOfOtherParts(std::span<const glm::dvec3> positions,
                                               std::span<const std::uint32_t> partOf, double distance);

} // namespace osgPMObjects::core
