// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace scenery::clouds
{

/// Returns gradient noise from about -1 to 1 that repeats after `cells` (a lattice of them, each 1 wide) in x
/// and y, and in z too where `cells.z` is above 0. The same on every machine.
/// Source: Perlin, *Improving noise* (2002), with a hash in place of his table.
float tiledNoise3(const glm::vec3& at, const glm::ivec3& cells, std::uint32_t seed);

/// Returns the sum of `octaves` of it, each twice as fine and half as strong; from about -1 to 1.
float tiledSum3(glm::vec3 at, glm::ivec3 cells, int octaves, std::uint32_t seed);

} // namespace scenery::clouds
