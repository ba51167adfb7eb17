// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Terrain.h"
#include "course/Alignment.h"

namespace islandgen
{

/// The least length of the course, metres.
inline constexpr double kLeastCourseM = 6500.0;

/// Finds a closed course of kLeastCourseM to about 8 km that suits the land near `middle`: gentle grades,
/// small cuttings and embankments, little cross slope, away from the sea. The corners of its polygon stay in
/// order around the middle, so it never crosses itself.
/// Method: from a circle, corners and the middle are moved at random, by less and less, and what makes the
/// course worse is taken back.
/// Deterministic: the seed decides. Cost: some seconds. Returns nothing where no circle suits (a terrain too
/// small).
std::optional<Alignment> searchCourse(const Terrain& terrain, const glm::dvec2& middle, std::uint64_t seed);

} // namespace islandgen
