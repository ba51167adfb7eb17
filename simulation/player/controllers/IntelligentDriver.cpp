// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "simulation/player/LeadVehicle.h"
#include "simulation/player/StopAhead.h"
#include "simulation/player/controllers/SpeedController.h"
#include "simulation/player/controllers/SpeedControllers.h"
#include "simulation/road/FollowingModel.h"
#include "simulation/road/StopSignals.h"

namespace simulation
{
namespace
{

/// Follows the vehicle ahead by the intelligent driver model:
/// a·(1 − (v / v0)⁴ − (s* / s)²), s* = s0 + v·T + v·Δv / (2·√(a·b)).
/// Properties (esmini's NaturalDriver has the first three): desiredSpeed v0, desiredDistance s0, desiredTHW
/// T, maxAcc a, comfortDec b.
class IntelligentDriver final : public SpeedController
{
public:
    IntelligentDriver(const Controller& controller, double speedMps)
        : _speedMps(speedMps),
          _desiredMps(controller.number("desiredSpeed", speedMps)),
          _distanceM(controller.number("desiredDistance", 2.0)),
          _headwayS(controller.number("desiredTHW", 1.5)),
          _accelerationMps2(controller.number("maxAcc", 1.5)),
          _decelerationMps2(controller.number("comfortDec", 2.0))
    {
    }

    double speedAfter(ActionScene& scene, int actor) override
    {
        constexpr double kLookAheadM = 200.0, kLateralM = 5.0, kBeforeLineM = 1.0;
        const double share = _desiredMps > 0.0 ? _speedMps / _desiredMps : 1.0;
        double acceleration = 1.0 - share * share * share * share;
        double crowd = 0.0;
        if (const auto lead = leadVehicleOf(scene, actor, kLookAheadM, kLateralM))
            crowd = crowdedBy(lead->gapM, scene.motion(lead->entity).state().speedMps);
        // A line to stop at is as one that stands with its back at the line.
        if (const auto gapM = lineAhead(scene, actor))
            crowd = std::max(crowd, crowdedBy(*gapM + _distanceM - kBeforeLineM, 0.0));
        acceleration -= crowd;
        Performance limits = performanceOf(scene.scenario().entities[static_cast<std::size_t>(actor)]);
        limits.maxDecelerationMps2 *= scene.grip();
        _speedMps += scene.stepS() * std::clamp(_accelerationMps2 * acceleration, -limits.maxDecelerationMps2,
                                                limits.maxAccelerationMps2);
        _speedMps = std::max(0.0, _speedMps);
        return _speedMps;
    }

    void askForSpeed(double speedMps) override { _desiredMps = speedMps; }
    void resume(double speedMps) override { _speedMps = speedMps; }

private:
    /// The gap to the next line at which it has to stop. At a sign it stands for a while, and then goes on.
    std::optional<double> lineAhead(ActionScene& scene, int actor)
    {
        constexpr double kLineM = 100.0, kStandingMps = 0.2, kAtLineM = 3.0, kLookS = 1.5;
        constexpr double kBrakes = 2.0; ///< of the comfortable deceleration, to stop at a light that turns
        if (!mayHaveToStop(scene)) return std::nullopt;
        const auto stop = stopAhead(scene, actor, {kLineM, kBrakes * _decelerationMps2, _servedSignM});
        if (!stop) return std::nullopt;
        if (stop->isSign && _speedMps < kStandingMps && stop->gapM < kAtLineM)
        {
            _waitedS += scene.stepS();
            if (_waitedS < kLookS) return stop->gapM;
            _waitedS = 0.0;
            _servedSignM = scene.motion(actor).state().odometerM + stop->gapM;
            return std::nullopt;
        }
        return stop->gapM;
    }

    bool mayHaveToStop(const ActionScene& scene)
    {
        if (!_hasSigns) _hasSigns = scene.roads() && hasStopSigns(scene.roads()->network());
        return *_hasSigns || !scene.signalStates().empty();
    }

    double crowdedBy(double gapM, double aheadMps) const
    {
        return crowding({_speedMps, gapM, aheadMps, _distanceM, _speedMps * _headwayS, _accelerationMps2,
                         _decelerationMps2});
    }

    double _speedMps;
    double _desiredMps, _distanceM, _headwayS, _accelerationMps2, _decelerationMps2;
    double _waitedS = 0.0; ///< at the sign ahead
    std::optional<double> _servedSignM;
    std::optional<bool> _hasSigns; ///< in the network; nothing: not looked for yet
};

} // namespace

std::unique_ptr<EntityController> makeIntelligentDriver(const Controller& controller, double speedMps)
{
    return std::make_unique<IntelligentDriver>(controller, speedMps);
}

} // namespace simulation
