// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/SpeedProfile.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "simulation/player/TransitionShape.h"

namespace simulation
{
namespace
{

double duration(double from, double to, const TransitionDynamics& dynamics)
{
    const double value = std::fabs(dynamics.value);
    if (dynamics.shape == DynamicsShape::step || from == to) return 0.0;
    if (dynamics.dimension == DynamicsDimension::time) return value;
    if (dynamics.dimension == DynamicsDimension::rate)
        return value > 0.0 ? steepestSlope(dynamics.shape) * std::fabs(to - from) / value
                           : std::numeric_limits<double>::infinity();
    const double mean = 0.5 * std::fabs(from + to);
    return mean > 0.0 ? value / mean : 0.0;
}

} // namespace

SpeedProfile::SpeedProfile(double fromMps, double toMps, const TransitionDynamics& dynamics)
    : _fromMps(fromMps), _toMps(toMps), _durationS(duration(fromMps, toMps, dynamics)), _shape(dynamics.shape)
{
}

TransitionDynamics SpeedProfile::within(double mostMps2, double fromMps, double toMps,
                                        const TransitionDynamics& dynamics)
{
    const double least = steepestSlope(dynamics.shape) * std::fabs(toMps - fromMps) / mostMps2;
    if (dynamics.shape == DynamicsShape::step || duration(fromMps, toMps, dynamics) >= least) return dynamics;
    return {dynamics.shape, DynamicsDimension::time, least};
}

SpeedProfile SpeedProfile::constant(double speedMps)
{
    return {speedMps, speedMps, {}};
}

double SpeedProfile::speedAt(double timeS) const
{
    if (timeS >= _durationS) return _toMps;
    if (timeS <= 0.0 || std::isinf(_durationS)) return _fromMps;
    const double s = timeS / _durationS;
    const double change = _toMps - _fromMps;
    if (_shape == DynamicsShape::cubic) return _fromMps + change * s * s * (3.0 - 2.0 * s);
    if (_shape == DynamicsShape::sinusoidal)
        return _fromMps + change * 0.5 * (1.0 - std::cos(std::numbers::pi * s));
    return _fromMps + change * s;
}

double SpeedProfile::distanceAt(double timeS) const
{
    if (timeS <= 0.0) return 0.0;
    if (std::isinf(_durationS)) return _fromMps * timeS;
    if (timeS >= _durationS) return 0.5 * (_fromMps + _toMps) * _durationS + _toMps * (timeS - _durationS);
    const double s = timeS / _durationS;
    const double change = (_toMps - _fromMps) * _durationS;
    const double even = _fromMps * timeS;
    if (_shape == DynamicsShape::cubic) return even + change * s * s * s * (1.0 - 0.5 * s);
    if (_shape == DynamicsShape::sinusoidal)
        return even + change * 0.5 * (s - std::sin(std::numbers::pi * s) / std::numbers::pi);
    return even + change * 0.5 * s * s;
}

} // namespace simulation
