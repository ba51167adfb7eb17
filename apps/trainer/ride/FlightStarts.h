// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "FlyRequest.h"

namespace trainer
{

/// Where a flight begins. Angles in degrees from north, clockwise.
struct FlightStart
{
    std::string name;
    glm::dvec2 place{0.0};
    double heightM = 0.0; ///< above the ground
    double headingDeg = 0.0, speedMps = 0.0;
};

/// Where flights of a request may begin; the first is its own.
std::vector<FlightStart> startsOf(const FlyRequest& request);

} // namespace trainer
