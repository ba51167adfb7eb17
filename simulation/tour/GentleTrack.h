// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// Finds a track for a vehicle between two points: the cheapest way over a grid of at most 256² nodes, where
/// a metre costs 1 + (grade/6 %)² + (cross slope/10 %)², rounded so that a car can follow it. Returns points
/// about `spacingM` apart, from `from` to `to`, which both must be inside the extent. Frame: the scene's.
/// Cost: about 0.1 s. Deterministic.
/// Source: Dijkstra, *A Note on Two Problems in Connexion with Graphs*, 1959, with sixteen moves per node.
std::vector<glm::dvec2> gentleTrack(const TourTerrain& terrain, const glm::dvec2& from, const glm::dvec2& to,
                                    double spacingM);

} // namespace simulation
