// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace scenery::models
{

/// Returns periodic value noise from 0 to 1: values on a lattice of `cells` by `cells` over the unit square,
/// interpolated smoothly. The same on every machine.
float tiledNoise(const glm::vec2& uv, const glm::ivec2& cells, std::uint32_t seed);

/// Returns the sum of `octaves` of value noise, each twice as fine and half as strong. From 0 to 1.
float tiledCloud(const glm::vec2& uv, const glm::ivec2& cells, int octaves, std::uint32_t seed);

} // namespace scenery::models
