// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "simulation/tour/ReliefMap.h"
#include "simulation/tour/TourScale.h"

namespace simulation
{

/// The plan (from above) of a flight, sampled at equal distances from 0 to the scale's length.
struct FlightPlan
{
    std::vector<glm::dvec2> places;
    std::vector<double> headingsRad; ///< counter-clockwise from east
    glm::dvec2 highlight{0.0};       ///< what lies ahead of its end
    double score = 0.0;
};

/// Candidate plans. Each is an S or a bow of bounded curvature that ends facing one of the terrain's highlights: the
/// most interesting cells that are not neighbours of a better one. A plan is rated by what a fan of looks ahead from
/// all along it meets: interest counts for it, the world's end against it. Of the plans that end at one distance from
/// one highlight the best is kept. Plans that leave the extent are dropped, unless all do.
/// Cost: some thousand plans of 24 fans of 25 looks. Deterministic: ties go to the first found.
std::vector<FlightPlan> flightPlans(const TourTerrain& terrain, const ReliefMap& map, const TourScale& scale);

} // namespace simulation
