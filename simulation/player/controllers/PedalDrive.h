// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "simulation/player/controllers/SpeedController.h"
#include "simulation/scenario/OverrideAction.h"

namespace simulation
{

/// The controls of an entity that actions have taken from whoever drives it.
struct Controls
{
    double throttle = 0.0, clutch = 0.0;
    ControlOverride brake, parkingBrake;
    GearLever lever = GearLever::forward;
    bool hasThrottle = false, hasGear = false;

    /// Takes over what an action says; what it gives back falls to its rest.
    void take(const OverrideAction& action);

    /// Whether one of those that change the speed is in force.
    bool isAny() const { return hasThrottle || brake.isActive || parkingBrake.isActive || hasGear; }
};

/// Changes the speed of an entity by its pedals, in place of actions and controllers: the throttle gives its
/// share of the greatest acceleration of the vehicle (none with the clutch pressed or out of gear, backwards
/// in reverse), a brake its share of the greatest deceleration, or its force over the mass (1500 kg where the
/// file gives none), as far as the road's friction allows, to a stand and no further.
class PedalDrive final : public SpeedController
{
public:
    PedalDrive(const Controls& controls, double speedMps) : _controls(controls), _speedMps(speedMps) {}

    double speedAfter(ActionScene& scene, int actor) override;
    void resume(double speedMps) override { _speedMps = speedMps; }

private:
    Controls _controls;
    double _speedMps;
};

} // namespace simulation
