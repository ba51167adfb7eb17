// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include <foundation/Random.h>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "scenery/models/Dice.h"

namespace worldmaking
{

/// A seed of its own for each thing of a world: for a stage, and for a place or number within it.
inline std::uint64_t seedFor(std::uint64_t world, std::uint64_t stage, std::uint64_t number = 0)
{
    return (world * foundation::SplitMix64::kStep) ^ (stage * 0xd1b54a32d192ed03ULL) ^
           (number * 0x2545f4914f6cdd1dULL);
}

/// Smooth noise of the plane, 0 … 1: random values at the corners of squares of `sideM`, blended by cubics.
/// Source: Perlin, *An image synthesizer*, 1985, with values in place of gradients.
inline double noiseAt(const glm::dvec2& place, double sideM, std::uint64_t seed)
{
    const double east = place.x / sideM, north = place.y / sideM;
    const double column = std::floor(east), row = std::floor(north);
    const auto value = [&](double dx, double dy)
    {
        const auto x = static_cast<std::uint64_t>(static_cast<std::int64_t>(column + dx)),
                   y = static_cast<std::uint64_t>(static_cast<std::int64_t>(row + dy));
        return scenery::models::Dice(seedFor(seed, x + 1, y + 1)).unit();
    };
    const double u = glm::smoothstep(0.0, 1.0, east - column), v = glm::smoothstep(0.0, 1.0, north - row);
    return (value(0, 0) * (1.0 - u) + value(1, 0) * u) * (1.0 - v) +
           (value(0, 1) * (1.0 - u) + value(1, 1) * u) * v;
}

/// Three octaves of it, from `sideM` down to a quarter.
inline double roughNoiseAt(const glm::dvec2& place, double sideM, std::uint64_t seed)
{
    return (4.0 * noiseAt(place, sideM, seed) + 2.0 * noiseAt(place, 0.5 * sideM, seed + 1) +
            noiseAt(place, 0.25 * sideM, seed + 2)) /
           7.0;
}

} // namespace worldmaking
