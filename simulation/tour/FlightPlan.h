// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "simulation/tour/ReliefMap.h"
#include "simulation/tour/TourScale.h"

namespace simulation
{

/// The path of a flight seen from above, sampled at equal distances from 0 to the length of the scale.
struct FlightPlan
{
    std::vector<glm::dvec2> places;
    std::vector<double> headingsRad; ///< counter-clockwise from east
    glm::dvec2 highlight{0.0};       ///< the point of interest that the end faces
    double score = 0.0;
    double filledShare = 0.0; ///< share of the ground ahead that was not measured, 0…1
};

/// Finds candidate paths. Each is a bow or an S of bounded curvature, and its end faces one of the highlights
/// of the terrain: the most interesting cells without a better neighbour. The rating of a path sums what is
/// seen ahead from all its samples (24 fans of 25 rays): interest counts for it, the edge of the terrain and
/// ground that was not measured against it. The best path is kept for each highlight and each distance from
/// it. Paths that leave the extent are dropped, unless all do.
/// Cost: some thousand paths. Deterministic: the first of equal ones wins.
std::vector<FlightPlan> flightPlans(const TourTerrain& terrain, const ReliefMap& map, const TourScale& scale);

} // namespace simulation
