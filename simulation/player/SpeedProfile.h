// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/scenario/Action.h"

namespace simulation
{

/// Speed over time while it goes from one value to another, in closed form: no sum over steps.
/// Dimension `distance`: the transition covers that distance; `rate`: its steepest change of speed is that value.
/// Units: seconds since its begin, m/s, metres.
/// Source: ASAM OpenSCENARIO XML 1.3, TransitionDynamics. All shapes are symmetric, so that each covers the mean of
/// the two speeds times its duration.
class SpeedProfile
{
public:
    SpeedProfile() = default;
    SpeedProfile(double fromMps, double toMps, const TransitionDynamics& dynamics);

    /// A constant speed.
    static SpeedProfile constant(double speedMps);

    double speedAt(double timeS) const;
    double distanceAt(double timeS) const;

    /// Infinite when the target is never reached (a rate of 0).
    double durationS() const { return _durationS; }

private:
    double _fromMps = 0.0;
    double _toMps = 0.0;
    double _durationS = 0.0;
    DynamicsShape _shape = DynamicsShape::step;
};

} // namespace simulation
