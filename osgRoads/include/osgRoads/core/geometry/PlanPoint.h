// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <glm/vec2.hpp>

namespace osgRoads::core
{

/// A point of a curve in the plan view: x east, y north, metres; heading in radians from x towards y;
/// curvature in 1/m, positive to the left.
struct PlanPoint
{
    glm::dvec2 position{0.0, 0.0};
    double headingRad = 0.0;
    double curvature = 0.0;

    glm::dvec2 tangent() const { return {std::cos(headingRad), std::sin(headingRad)}; }
};

} // namespace osgRoads::core
