// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/control/flight/FlightSense.h"

namespace simulation
{

/// A straight line over the ground that an aircraft flies along.
struct CourseLine
{
    glm::dvec2 point{0.0}; ///< scene
    double course = 0.0;   ///< from north, clockwise; radians

    glm::dvec2 along() const;
    /// How far a place is beside the line, positive to the right, and along it from the point. Units: m.
    double besideM(const glm::dvec3& place) const;
    double alongM(const glm::dvec3& place) const;
};

/// The bank that turns to a heading or, with wind, to a track. Radians.
double bankToHeading(const FlightSense& sense, double heading, double mostBank);

/// The bank that leads onto a line and keeps to it, whatever the wind: the wanted track leans towards the
/// line by the distance from it.
/// Source: Beard, McLain, *Small Unmanned Aircraft*, 2012, section 10.1 (following a straight line).
double bankToLine(const FlightSense& sense, const CourseLine& line, double mostBank);

/// What throttle and pitch are set to.
struct PowerAndPitch
{
    double throttle = 0.0;
    double pitch = 0.0; ///< radians
};

/// Throttle and pitch for speed and climb. Two ways: the throttle keeps the speed while pitch keeps the climb
/// (level flight, glide path), or a given throttle stands and pitch keeps the speed (climb).
class SpeedAndClimb
{
public:
    /// The throttle for a calibrated airspeed, pitch for a vertical speed.
    PowerAndPitch holdClimb(const FlightSense& sense, double speedMps, double climbMps, double stepS);

    /// A given throttle, pitch for a calibrated airspeed.
    PowerAndPitch holdSpeed(const FlightSense& sense, double throttle, double speedMps, double stepS);

    /// Begins from what is flown now.
    void reset(const FlightSense& sense, double throttle);

private:
    /// How fast the airspeed has changed since the step before; keeps it for the next. Units: m/s².
    double speedRate(double speedMps, double stepS);

    double _throttle = 0.5;
    double _attack = 0.05;    ///< pitch less path, slowly followed
    double _climbPitch = 0.1; ///< the integral part of holdSpeed()
    double _lastSpeedMps = 0.0;
    bool _hasLastSpeed = false;
};

/// The vertical speed that leads to an altitude: as far as it is away, within limits. Units: m, m/s.
double climbToAltitude(double altitudeM, double wantedM, double mostMps);

} // namespace simulation
