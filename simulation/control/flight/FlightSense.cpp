// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/FlightSense.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/vehicle/StandardAtmosphere.h"

namespace simulation
{
namespace
{

constexpr double kLeastAirspeedMps = 1.0; ///< below it angles of the air mean nothing

} // namespace

double halfTurn(double angle)
{
    return foundation::wrappedRad(angle);
}

FlightSense senseOf(const ControlView& view, const EarthFrame& earth, double wheelsBelowM)
{
    FlightSense sense;
    const VehicleState& state = view.state;
    const EarthFrame::Place place = earth.placeAt(state.position);
    // Half a turn about the nose leads from forward, left, up to forward, right, down.
    const glm::dquat attitude = state.bodyToScene * glm::dquat(0.0, 1.0, 0.0, 0.0);
    const LevelAngles angles = levelAngles(place, attitude);
    sense.position = state.position;
    sense.heading = angles.heading;
    sense.pitch = angles.pitch;
    sense.roll = angles.roll;
    sense.rollRate = state.bodyRates.x;
    sense.pitchRate = -state.bodyRates.y;
    sense.yawRate = -state.bodyRates.z;
    sense.climbMps = glm::dot(state.velocity, place.up);
    sense.groundSpeedMps = std::hypot(state.velocity.x, state.velocity.y);
    sense.track = std::atan2(state.velocity.x, state.velocity.y);
    sense.altitudeM = place.geodetic.heightM;
    const AirSample air = view.air.at(state.position, sense.altitudeM, view.timeS);
    sense.windMps = air.windMps;
    const glm::dvec3 through = glm::conjugate(attitude) * (state.velocity - air.windMps);
    sense.trueAirspeedMps = glm::length(through);
    sense.calibratedAirspeedMps =
        calibratedAirspeed(sense.trueAirspeedMps, {air.pressurePa, air.temperatureK, air.densityKgPerM3});
    if (sense.trueAirspeedMps > kLeastAirspeedMps)
    {
        sense.sideslip = std::asin(std::clamp(through.y / sense.trueAirspeedMps, -1.0, 1.0));
        sense.pathAngle = std::asin(std::clamp(sense.climbMps / sense.trueAirspeedMps, -1.0, 1.0));
    }
    GroundPoint below;
    view.ground.below({&state.position, 1}, {&below, 1});
    sense.wheelHeightM = (below.isKnown ? state.position.z - below.heightM : sense.altitudeM) - wheelsBelowM;
    sense.isOnGround = state.isOnGround;
    return sense;
}

} // namespace simulation
