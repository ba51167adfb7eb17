// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// A track for a vehicle from one place to another: the cheapest of all ways over a grid of at most 256² nodes, where a
/// metre costs 1 + (grade/6 %)² + (cross slope/10 %)², then rounded so that a car can follow it.
/// Returned: places about `spacingM` apart, first `from`, last `to`, which both must lie in the extent. Frame: the
/// scene's.
/// Cost: about 0.1 s. Deterministic.
/// Source: Dijkstra 1959, over sixteen moves per node.
std::vector<glm::dvec2> gentleTrack(const TourTerrain& terrain, const glm::dvec2& from, const glm::dvec2& to,
                                    double spacingM);

} // namespace simulation
