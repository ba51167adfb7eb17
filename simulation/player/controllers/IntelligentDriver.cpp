// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "simulation/player/LeadVehicle.h"
#include "simulation/player/StopAhead.h"
#include "simulation/player/controllers/SpeedController.h"
#include "simulation/player/controllers/SpeedControllers.h"
#include "simulation/player/way/WayDriver.h"
#include "simulation/road/FollowingModel.h"
#include "simulation/road/StopSignals.h"

namespace simulation
{
namespace
{

/// Follows the vehicle ahead by the intelligent driver model:
/// a·(1 − (v / v0)⁴ − (s* / s)²), s* = s0 + v·T + v·Δv / (2·√(a·b)).
/// Properties (esmini's NaturalDriver has the first three): desiredSpeed v0, desiredDistance s0, desiredTHW
/// T, maxAcc a, comfortDec b. With keepsRules it drives as fast as limits and bends allow (desiredSpeed is
/// the most, limitShare what it drives of the limits), sees all that is on its way, heeds lights and signs,
/// and gives way at junctions unless givesWay is false. Such a one that has touched somebody who does not
/// keep the rules, as a person, brakes hard and stays where it is.
class IntelligentDriver final : public SpeedController
{
public:
    IntelligentDriver(const Controller& controller, double speedMps)
        : _speedMps(speedMps),
          _desiredMps(controller.number("desiredSpeed", speedMps)),
          _distanceM(controller.number("desiredDistance", 2.0)),
          _headwayS(controller.number("desiredTHW", 1.5)),
          _accelerationMps2(controller.number("maxAcc", 1.5)),
          _decelerationMps2(controller.number("comfortDec", 2.0)),
          _limitShare(controller.number("limitShare", 1.0)),
          _keepsRules(controller.properties.find("keepsRules") == "true"),
          _givesWay(controller.properties.find("givesWay") != "false")
    {
        if (_keepsRules && !controller.properties.find("desiredSpeed")) _desiredMps = kAnyMps;
    }

    double speedAfter(ActionScene& scene, int actor) override
    {
        constexpr double kLookAheadM = 200.0, kLateralM = 5.0, kBeforeLineM = 1.0;
        const auto advice = rulesAhead(scene, actor);
        if (advice && hasTouched(scene, actor)) return _speedMps = brakedHard(scene, actor);
        const double wantedMps =
            advice ? std::min(_desiredMps, _limitShare * advice->allowedMps) : _desiredMps;
        const double share = wantedMps > 0.0 ? _speedMps / wantedMps : 1.0;
        double acceleration = 1.0 - share * share * share * share;
        double crowd = 0.0;
        if (advice)
        {
            if (advice->lead) crowd = crowdedBy(advice->lead->gapM, advice->lead->speedMps);
            if (advice->lineM) crowd = std::max(crowd, crowdedBy(*advice->lineM + _distanceM, 0.0));
            if (advice->lightM) crowd = std::max(crowd, crowdedBy(*advice->lightM + _distanceM, 0.0));
        }
        else if (const auto lead = leadVehicleOf(scene, actor, kLookAheadM, kLateralM))
            crowd = crowdedBy(lead->gapM, scene.motion(lead->entity).state().speedMps);
        // A line to stop at is as one that stands with its back at the line.
        if (const auto gapM = advice ? signAhead(scene, actor, advice->signM) : lineAhead(scene, actor))
            crowd = std::max(crowd, crowdedBy(*gapM + _distanceM - kBeforeLineM, 0.0));
        acceleration -= crowd;
        const Performance limits = limitsOf(scene, actor);
        _speedMps += scene.stepS() * std::clamp(_accelerationMps2 * acceleration, -limits.maxDecelerationMps2,
                                                limits.maxAccelerationMps2);
        _speedMps = std::max(0.0, _speedMps);
        return _speedMps;
    }

    void askForSpeed(double speedMps) override { _desiredMps = speedMps; }
    void resume(double speedMps) override { _speedMps = speedMps; }

private:
    static constexpr double kAnyMps = 100.0; ///< whatever is allowed
    /// of the comfortable deceleration, to stop at a line that comes late
    static constexpr double kBrakes = 2.0;

    /// Nothing: it does not keep the rules, or is on no road.
    std::optional<WayAdvice> rulesAhead(ActionScene& scene, int actor)
    {
        if (!_keepsRules || !scene.roads()) return std::nullopt;
        if (!_way) _way = std::make_unique<WayDriver>(scene, scene.junctions(), actor, _givesWay);
        return _way->look(scene, _speedMps);
    }

    static Performance limitsOf(const ActionScene& scene, int actor)
    {
        Performance limits = performanceOf(scene.scenario().entities[static_cast<std::size_t>(actor)]);
        limits.maxDecelerationMps2 *= scene.grip();
        return limits;
    }

    /// Whether it is, or has been, in an accident with a stranger.
    bool hasTouched(ActionScene& scene, int actor)
    {
        if (_hasTouched) return true;
        const Traffic seen = scene.trafficOf(actor);
        for (const int other : seen.entities[static_cast<std::size_t>(actor)].collidesWith)
            _hasTouched = _hasTouched || !scene.junctions()->isKept(other);
        return _hasTouched;
    }

    double brakedHard(const ActionScene& scene, int actor) const
    {
        return std::max(0.0, _speedMps - scene.stepS() * limitsOf(scene, actor).maxDecelerationMps2);
    }

    /// The gap to the next stop sign, unless it has stood there; of one that keeps the rules.
    std::optional<double> signAhead(ActionScene& scene, int actor, std::optional<double> gapM)
    {
        if (!gapM || comesTooLate(*gapM, _speedMps, kBrakes * _decelerationMps2)) return std::nullopt;
        return heldBySign(scene, actor, *gapM) ? gapM : std::nullopt;
    }

    bool heldBySign(ActionScene& scene, int actor, double gapM)
    {
        return _signs.holds(scene.motion(actor).state().odometerM + gapM, gapM, _speedMps, scene.stepS());
    }

    /// The gap to the next line at which it has to stop.
    std::optional<double> lineAhead(ActionScene& scene, int actor)
    {
        constexpr double kLineM = 100.0;
        if (!mayHaveToStop(scene)) return std::nullopt;
        const auto stop = stopAhead(scene, actor, {kLineM, kBrakes * _decelerationMps2, &_signs});
        if (!stop || (stop->isSign && !heldBySign(scene, actor, stop->gapM))) return std::nullopt;
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
    double _limitShare;
    bool _keepsRules, _givesWay;
    bool _hasTouched = false;        ///< a stranger
    std::unique_ptr<WayDriver> _way; ///< of one that keeps the rules, once it has looked
    StopAtSign _signs;               ///< by the odometer of its front
    std::optional<bool> _hasSigns;   ///< in the network; nothing: not looked for yet
};

} // namespace

std::unique_ptr<EntityController> makeIntelligentDriver(const Controller& controller, double speedMps)
{
    return std::make_unique<IntelligentDriver>(controller, speedMps);
}

} // namespace simulation
