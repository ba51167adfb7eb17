// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/control/VehicleController.h"
#include "simulation/vehicle/EarthFrame.h"

namespace simulation
{

/// What an autopilot knows of its aircraft: instruments, not the inside of a flight model, so that it flies
/// any aircraft.
/// Units: radians, metres, m/s. Headings and tracks from north, clockwise.
struct FlightSense
{
    glm::dvec3 position{0.0};
    double heading = 0.0, pitch = 0.0, roll = 0.0;         ///< nose up, right wing down
    double rollRate = 0.0, pitchRate = 0.0, yawRate = 0.0; ///< right wing down, nose up, nose right
    double track = 0.0;                                    ///< over the ground
    double groundSpeedMps = 0.0;
    double trueAirspeedMps = 0.0, calibratedAirspeedMps = 0.0;
    double sideslip = 0.0; ///< positive: the air comes from the right
    double climbMps = 0.0;
    double pathAngle = 0.0;    ///< of the climb through the air
    double altitudeM = 0.0;    ///< above the ellipsoid
    double wheelHeightM = 0.0; ///< of the main wheels above the ground below
    glm::dvec3 windMps{0.0};   ///< scene
    bool isOnGround = false;
};

/// Reads the instruments. `wheelsBelowM`: how far the unloaded main wheels are below the centre of mass,
/// level.
FlightSense senseOf(const ControlView& view, const EarthFrame& earth, double wheelsBelowM);

/// An angle within half a turn. Radians.
double halfTurn(double angle);

} // namespace simulation
