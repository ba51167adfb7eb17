// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace simulation
{

enum class DynamicsShape
{
    step,
    linear,
    cubic,
    sinusoidal,
};

enum class DynamicsDimension
{
    time,     ///< seconds
    distance, ///< metres
    rate,     ///< metres per second, per second
};

struct TransitionDynamics
{
    DynamicsShape shape = DynamicsShape::step;
    DynamicsDimension dimension = DynamicsDimension::time;
    double value = 0.0;

    bool operator==(const TransitionDynamics&) const = default;
};

} // namespace simulation
