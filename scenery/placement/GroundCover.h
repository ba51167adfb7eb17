// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace scenery
{

/// What grows and lies on the ground near the eye.
enum class CoverShape : std::uint8_t
{
    grass,
    herb,
    stone,
    twig,
};
constexpr int kCoverShapes = 4;

/// The ground at a place, for what grows on it: its height (m) and shares 0 … 1; the rest of it is bare.
struct CoverGround
{
    double heightM = 0.0;
    float grass = 0.0F, stones = 0.0F, litter = 0.0F;
};

/// Answers what is at (east, north); nothing where nothing may stand: roads, water, snow, beyond the data.
using CoverQuery = std::function<std::optional<CoverGround>(glm::dvec2 place)>;

/// How far things are drawn: half of them to the nearest reach, the fewest to the farthest, so that they get
/// fewer with the distance and end nowhere. Units: metres.
constexpr std::array<double, 3> kCoverReachesM{25.0, 45.0, 80.0};
constexpr std::array<double, 3> kCoverShares{0.5, 0.3, 0.2};

/// One thing. Frame: the scene's. Units: metres, radians.
struct CoverThing
{
    glm::dvec3 position{0.0};
    double headingRad = 0.0, scale = 1.0;
    CoverShape shape = CoverShape::grass;
    std::uint8_t reach = 0; ///< of kCoverReachesM
};

/// Returns what stands in a square of kCoverCellM, whose south-western corner is at `cell` times that, of the
/// things that reach as far as `leastReach` or farther. It depends on nothing else: a cell is the same
/// whenever the eye comes. Cost: some 225 queries where the least reach is 0.
constexpr double kCoverCellM = 8.0;
std::vector<CoverThing> coverOf(glm::ivec2 cell, std::uint8_t leastReach, const CoverQuery& query);

} // namespace scenery
