// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include <glm/common.hpp>

#include "simulation/scenario/Dynamics.h"

namespace simulation
{

/// The course of a transition from 0 to 1 while `x` goes from 0 to 1.
/// Source: ASAM OpenSCENARIO XML 1.3, DynamicsShape.
inline double shapeValue(DynamicsShape shape, double x)
{
    if (shape == DynamicsShape::step || x >= 1.0) return 1.0;
    if (x <= 0.0) return 0.0;
    if (shape == DynamicsShape::cubic) return glm::smoothstep(0.0, 1.0, x);
    if (shape == DynamicsShape::sinusoidal) return 0.5 * (1.0 - std::cos(std::numbers::pi * x));
    return x;
}

/// Its derivative.
inline double shapeSlope(DynamicsShape shape, double x)
{
    if (shape == DynamicsShape::step || x < 0.0 || x >= 1.0) return 0.0;
    if (shape == DynamicsShape::cubic) return 6.0 * x * (1.0 - x);
    if (shape == DynamicsShape::sinusoidal) return 0.5 * std::numbers::pi * std::sin(std::numbers::pi * x);
    return 1.0;
}

/// Its steepest slope.
inline double steepestSlope(DynamicsShape shape)
{
    if (shape == DynamicsShape::cubic) return 1.5;
    if (shape == DynamicsShape::sinusoidal) return 0.5 * std::numbers::pi;
    return 1.0;
}

/// Its greatest second derivative; 0: none but at the ends.
inline double greatestBend(DynamicsShape shape)
{
    if (shape == DynamicsShape::cubic) return 6.0;
    if (shape == DynamicsShape::sinusoidal) return 0.5 * std::numbers::pi * std::numbers::pi;
    return 0.0;
}

} // namespace simulation
