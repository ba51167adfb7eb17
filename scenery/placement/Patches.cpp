// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/Patches.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/Random.h>
#include <glm/common.hpp>

#include "scenery/models/Dice.h"

namespace scenery
{

namespace
{

double lattice(std::int64_t x, std::int64_t y, std::uint64_t seed)
{
    const auto mixed = static_cast<std::uint64_t>(x) * foundation::SplitMix64::kStep ^
                       static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fULL ^ seed * 0x165667b19e3779f9ULL;
    return models::Dice(mixed).unit();
}

double noise(glm::dvec2 place, std::uint64_t seed)
{
    const double x0 = std::floor(place.x), y0 = std::floor(place.y);
    const auto x = static_cast<std::int64_t>(x0), y = static_cast<std::int64_t>(y0);
    const double u = glm::smoothstep(0.0, 1.0, place.x - x0), v = glm::smoothstep(0.0, 1.0, place.y - y0);
    const double south = lattice(x, y, seed) * (1.0 - u) + lattice(x + 1, y, seed) * u;
    const double north = lattice(x, y + 1, seed) * (1.0 - u) + lattice(x + 1, y + 1, seed) * u;
    return south * (1.0 - v) + north * v;
}

/// What share of the plane lies below a value of the sum, in tenths; measured over 10⁶ places.
constexpr std::array kBelow{0.0, 0.291, 0.356, 0.408, 0.455, 0.5, 0.545, 0.592, 0.644, 0.709, 1.0};

} // namespace

bool isInPatch(glm::dvec2 place, double sizeM, double share, std::uint64_t seed)
{
    const glm::dvec2 grid = place / sizeM;
    const double value = 0.7 * noise(grid, seed) + 0.3 * noise(grid * 2.7 + glm::dvec2(0.37, 0.71), seed + 1);
    const double below = std::clamp(1.0 - share, 0.0, 1.0) * 10.0;
    const auto tenth = std::min<std::size_t>(static_cast<std::size_t>(below), kBelow.size() - 2);
    const double within = below - static_cast<double>(tenth);
    return value >= kBelow[tenth] + within * (kBelow[tenth + 1] - kBelow[tenth]);
}

} // namespace scenery
