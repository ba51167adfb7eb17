// SPDX-License-Identifier: Apache-2.0
// How fast a driver wants to be, and what feet do for it.
#include <algorithm>
#include <cmath>

#include "simulation/control/driver/Driver.h"
#include "simulation/road/FollowingModel.h"

namespace simulation
{

namespace
{

constexpr double kSlowsPerS = 2.0; ///< deceleration for each m/s too fast

} // namespace

/// Slows down to a new wish no harder than for a bend.
void Driver::followWish(double speedMps)
{
    if (_settings.speedMps != _wishMps)
        _gentleMps = std::max(_settings.speedMps, std::min(_gentleMps, speedMps));
    _wishMps = _settings.speedMps;
    _gentleMps = std::max(_wishMps, _gentleMps - _settings.brakeMps2 * RoadVehicle::kStepS);
}

/// As fast as limit and bends allow, so that the brakes reach each bend in time.
double Driver::wantedSpeed(double speedMps) const
{
    double wanted = std::min(_gentleMps, _path.limitAt(_beside.alongM));
    const double seen = 20.0 + speedMps * speedMps / _settings.brakeMps2;
    for (double ahead = 0.0; ahead < std::min(seen, kSeenM); ahead += 2.0)
    {
        const double at = _beside.alongM + ahead;
        const double bend =
            std::sqrt(_settings.lateralMps2 / std::max(1e-6, std::abs(_path.curvatureAt(at))));
        const double there = std::min(bend, _path.limitAt(at));
        wanted = std::min(wanted, std::sqrt(there * there + 2.0 * 0.6 * _settings.brakeMps2 * ahead));
    }
    return std::max(wanted, 0.5);
}

/// The acceleration that the wish and whoever is ahead allow.
double Driver::acceleration(double speedMps, const Ahead& ahead) const
{
    const double wish = wantedSpeed(speedMps);
    const double headwayM = speedMps * _settings.headwayS * (ahead.speedMps > 0.5 ? 1.0 : 0.2);
    const double crowd = crowding({speedMps, ahead.gapM, ahead.speedMps, _settings.gapM, headwayM,
                                   _settings.accelerateMps2, _settings.brakeMps2});
    double wanted = _settings.accelerateMps2 * (1.0 - std::pow(std::max(0.0, speedMps) / wish, 4.0) - crowd);
    if (speedMps > wish) wanted = std::min(wanted, kSlowsPerS * (wish - speedMps));
    return std::clamp(wanted, -8.0, _settings.accelerateMps2);
}

/// Feet: a speed that the wanted acceleration leads to is held by throttle and brake.
void Driver::pedals(double wantedMps2, double speedMps, RoadInputs& inputs)
{
    _referenceMps =
        std::clamp(_referenceMps + wantedMps2 * RoadVehicle::kStepS, speedMps - 1.0, speedMps + 1.0);
    _referenceMps = std::max(0.0, _referenceMps);
    const double missing = _referenceMps - speedMps;
    _held = std::clamp(_held + 0.3 * missing * RoadVehicle::kStepS, -0.3, 1.0);
    double push = 0.08 * wantedMps2 + 0.5 * missing + _held;
    const bool stands = speedMps < kStandsMps && wantedMps2 <= 0.0;
    if (stands)
    {
        push = -1.0;
        _held = 0.0;
        _referenceMps = 0.0;
    }
    _hand.control(_vehicle, std::clamp(push, 0.0, 1.0), inputs);
    inputs[static_cast<std::size_t>(RoadInput::brake)] = std::clamp(-0.6 * push, 0.0, 1.0);
    inputs[static_cast<std::size_t>(RoadInput::handbrake)] = 0.0;
}

} // namespace simulation
