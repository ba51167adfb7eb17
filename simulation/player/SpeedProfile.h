// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/scenario/Action.h"

namespace simulation
{

/// The speed over time during a change from one value to another, in closed form: nothing is summed over
/// steps. Dimension `distance`: the change takes that distance; `rate`: its steepest change of speed has that
/// value.
/// Units: seconds since its start, m/s, metres.
/// Source: ASAM, *OpenSCENARIO XML* 1.3, TransitionDynamics. All shapes are symmetric, so the distance is the
/// mean of both speeds times the duration.
class SpeedProfile
{
public:
    SpeedProfile() = default;
    SpeedProfile(double fromMps, double toMps, const TransitionDynamics& dynamics);

    /// A constant speed.
    static SpeedProfile constant(double speedMps);

    /// Returns the dynamics of the same change that need no more than an acceleration: they take longer where
    /// they must. A step stays one.
    static TransitionDynamics within(double mostMps2, double fromMps, double toMps,
                                     const TransitionDynamics& dynamics);

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
