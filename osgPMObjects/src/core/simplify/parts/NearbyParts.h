// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// Finds for each position the nearest one in another part, within `distance`; ~0 where there is none.
/// `partOf`: by position, ~0 for unused ones. Cost: about linear when few are within the distance.
/// Source: Garland and Heckbert, *Surface simplification using quadric error metrics* (1997), section 3.2
/// (pairs within a threshold).
/// Differs: one pair a position, between parts only.
std::vector<std::uint32_t> nearestOfOtherParts(std::span<const glm::dvec3> positions,
                                               std::span<const std::uint32_t> partOf, double distance);

/// Finds for each position the nearest one within `distance` that no way along edges of up to three times
/// `distance` leads to; ~0 where there is none, and for positions without triangles. Source: as above (pairs
/// within a threshold). Cost: for each position, the edges so near.
std::vector<std::uint32_t> nearestAcrossGaps(std::span<const glm::dvec3> positions,
                                             std::span<const Triangle> triangles, double distance);

} // namespace osgPMObjects::core
