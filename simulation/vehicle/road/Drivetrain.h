// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/vehicle/road/RoadInputs.h"
#include "simulation/vehicle/road/RoadVehicleData.h"

namespace simulation
{

/// What turns between the engine and the wheels.
struct DrivetrainState
{
    double engineRadps = 0.0;
    double torqueShare = 0.0; ///< of the full torque, follows the pedal
    int gear = 0;             ///< -1 reverse, 0 neutral
    int lastGear = 0;         ///< before the shift that is under way
    double shiftingS = 0.0;   ///< what is left of that shift
    bool isLockedUp = false;  ///< the converter's clutch
    bool isStalled = false;
};

/// Engine, clutch or converter, gearbox and final drive.
///
/// A clutch is dry friction, solved for the torque that makes both sides turn alike within the step, up to
/// what it carries; a converter follows its tables. An automatic shifts by engine speed and pedal. The engine
/// is held at idle, fades out above its limit, and stalls when a closed clutch turns it too slowly; with the
/// clutch pressed, or in neutral, it starts anew.
/// Source: Kiencke, Nielsen, *Automotive Control Systems*, 2nd edition, 2005, chapters 5 and 6 (driveline,
/// converter).
class Drivetrain
{
public:
    /// `vehicle` must outlive this.
    explicit Drivetrain(const RoadVehicleData& vehicle) : _vehicle(vehicle) { reset(); }

    void reset();

    /// Puts in the gear that suits wheels that turn already, the engine turning with them.
    void begin(double shaftRadps);

    /// Chooses gears; once a step. `shaftRadps`: of the driven wheels' mean.
    void choose(const RoadInputs& inputs, double shaftRadps, double stepS);

    /// Advances the engine, and returns the torque on all driven wheels together. Units: Nm.
    /// `wheelsInertiaKgM2`: of all driven wheels.
    double drive(const RoadInputs& inputs, double shaftRadps, double wheelsInertiaKgM2, double stepS);

    /// The engine stands from now on.
    void stop() { _state.engineRadps = 0.0, _state.isStalled = true, _isBroken = true; }

    /// Inertia of what turns with the driven wheels besides them. Units: kg m².
    double reflectedInertia() const { return _vehicle.gearbox.inertiaKgM2 * ratioNow() * ratioNow(); }

    const DrivetrainState& state() const { return _state; }
    bool isFinite() const;

private:
    double ratioNow() const;
    double ratioOf(int gear) const;
    double engineTorque(double throttle) const;
    double clutchTorque(double mostNm, double engineNm, double inputRadps, double inputInertia, double stepS);
    double converterTorque(double inputRadps, double& turbineNm) const;
    void shiftTo(int gear);
    void chooseAutomatic(double throttle, double shaftRadps);

    const RoadVehicleData& _vehicle;
    DrivetrainState _state;
    bool _isBroken = false;
};

} // namespace simulation
