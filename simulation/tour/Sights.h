// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// Returns the settlements among houses: groups of kLeastHouses or more, in which a house has another within
/// some 250 m, in the order of their weight. A hamlet of eight weighs 0.2, a village of 60 two thirds, a
/// town of 700 five quarters. Frame: the scene's. Cost: linear. Deterministic.
std::vector<Sight> settlementSights(std::span<const glm::dvec2> houses);

/// Returns stretches of shore, kShoreEveryM or more from each other: where land of a terrain meets ground at
/// the height of the sea. `seaLevelM`: z of the sea at the frame's origin. Deterministic.
std::vector<Sight> shoreSights(const TourTerrain& terrain, double seaLevelM);

inline constexpr std::size_t kLeastHouses = 8;
inline constexpr double kShoreEveryM = 1500.0;

} // namespace simulation
