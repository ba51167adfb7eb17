// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace scenery::models
{

/// Noise that repeats, so that pictures can be laid side by side: values of a lattice of `cells` by `cells` over the unit
/// square, joined smoothly. From 0 to 1. The same on every machine.
float tiledNoise(const glm::vec2& uv, const glm::ivec2& cells, std::uint32_t seed);

/// The sum of `octaves` of it, each twice as fine and half as strong. From 0 to 1.
float tiledCloud(const glm::vec2& uv, const glm::ivec2& cells, int octaves, std::uint32_t seed);

} // namespace scenery::models
