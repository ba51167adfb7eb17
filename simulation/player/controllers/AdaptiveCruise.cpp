// SPDX-License-Identifier: Apache-2.0
// Source: the law that esmini 3.6 drives in acc-test (tests/core/simulation/RecordedScenarioTest.cpp).
#include <algorithm>
#include <cmath>

#include "simulation/player/LeadVehicle.h"
#include "simulation/player/controllers/SpeedController.h"
#include "simulation/player/controllers/SpeedControllers.h"

namespace simulation
{
namespace
{

constexpr double kLeastGapM = 3.0;
constexpr double kStopGapM = 1.0;
constexpr double kRoomMps2 = 2.5;  ///< of acceleration where there is room
constexpr double kFreeShare = 0.7; ///< of the greatest acceleration, where the road is free

/// esmini's ACCController. With `x` = (gap − wanted gap) / wanted gap, at most 1, the acceleration is
/// x·(2.5 m/s² + own set speed − speed of the lead) − (own speed − speed of the lead): the set speed rules
/// where there is room, the speed of the lead where the gap is as wanted. The wanted gap is 3 m and the way
/// of `timeGap` seconds.
class AdaptiveCruise final : public SpeedController
{
public:
    AdaptiveCruise(const Controller& controller, double speedMps)
        : _speedMps(speedMps),
          _timeGapS(controller.number("timeGap", 1.5)),
          _lateralM(controller.number("lateralDist", 5.0)),
          _hearsActions(controller.properties.find("mode").value_or("additive") != "override"),
          _setSpeedMps(_hearsActions ? speedMps : controller.number("setSpeed", speedMps))
    {
    }

    double speedAfter(ActionScene& scene, int actor) override
    {
        Performance limits = performanceOf(scene.scenario().entities[static_cast<std::size_t>(actor)]);
        limits.maxDecelerationMps2 *= scene.grip();
        const double braking = std::max(limits.maxDecelerationMps2, 0.1);
        const double lookAheadM = std::max(50.0, 2.0 * kLeastGapM + _speedMps * _speedMps / braking);
        if (const auto lead = leadVehicleOf(scene, actor, lookAheadM, _lateralM))
            follow(*lead, scene.motion(lead->entity).state().speedMps, limits, scene.stepS());
        else
            goFree(limits, scene.stepS());
        return _speedMps;
    }

    void resume(double speedMps) override { _speedMps = speedMps; }

    void askForSpeed(double speedMps) override
    {
        if (_hearsActions) _setSpeedMps = speedMps;
    }

private:
    void follow(const LeadVehicle& lead, double leadMps, const Performance& limits, double stepS)
    {
        if (lead.gapM < kStopGapM)
        {
            _speedMps = 0.0;
            return;
        }
        const double wantedM = kLeastGapM + _timeGapS * std::fabs(std::max(_speedMps, leadMps));
        const double room = std::min(1.0, (lead.gapM - wantedM) / wantedM);
        const double towards = std::min(_setSpeedMps, leadMps);
        const double acceleration = room * (kRoomMps2 + _setSpeedMps - towards) - (_speedMps - towards);
        const double change =
            stepS * std::clamp(acceleration, -limits.maxDecelerationMps2, limits.maxAccelerationMps2);
        _speedMps = std::clamp(_speedMps + change, 0.0, std::max(_speedMps, _setSpeedMps));
    }

    void goFree(const Performance& limits, double stepS)
    {
        const double most = kFreeShare * limits.maxAccelerationMps2;
        const double missing = _setSpeedMps - _speedMps;
        const double change = stepS * std::clamp(missing * most, -limits.maxDecelerationMps2, most);
        _speedMps = std::fabs(change) > std::fabs(missing) ? _setSpeedMps : _speedMps + change;
    }

    double _speedMps;
    double _timeGapS;
    double _lateralM;
    bool _hearsActions; ///< mode `additive`
    double _setSpeedMps;
};

} // namespace

std::unique_ptr<EntityController> makeAdaptiveCruise(const Controller& controller, double speedMps)
{
    return std::make_unique<AdaptiveCruise>(controller, speedMps);
}

} // namespace simulation
