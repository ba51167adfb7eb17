// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/StateBetween.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

namespace simulation
{

namespace
{

double mixed(double from, double to, double share)
{
    return from + share * (to - from);
}

/// Degrees, in the range of `to`'s full turn.
double mixedDeg(double fromDeg, double toDeg, double share)
{
    return toDeg - (1.0 - share) * foundation::wrappedDeg(toDeg - fromDeg);
}

/// -180…180
double signedDeg(double deg)
{
    return foundation::wrappedDeg(deg);
}

/// 0…360
double turnDeg(double deg)
{
    const double rest = std::fmod(deg, 360.0);
    return rest < 0.0 ? rest + 360.0 : rest;
}

bool isJump(const EntityState& from, const EntityState& to, double stepS)
{
    constexpr double kNearM = 0.5; // a step's change of velocity, and rounding
    const double fastest = std::max(glm::length(from.velocity), glm::length(to.velocity));
    return glm::distance(from.position, to.position) > kNearM + 2.0 * fastest * stepS;
}

AircraftParts partsBetween(const AircraftParts& from, const AircraftParts& to, double share)
{
    AircraftParts parts = to;
    for (double AircraftParts::*part :
         {&AircraftParts::elevatorDeg, &AircraftParts::leftAileronDeg, &AircraftParts::rightAileronDeg,
          &AircraftParts::rudderDeg, &AircraftParts::flapDeg, &AircraftParts::propellerRadps,
          &AircraftParts::noseSteeringDeg})
        parts.*part = mixed(from.*part, to.*part, share);
    parts.propellerTurnDeg = turnDeg(mixedDeg(from.propellerTurnDeg, to.propellerTurnDeg, share));
    for (std::size_t leg = 0; leg < parts.strutM.size(); ++leg)
    {
        parts.strutM[leg] = mixed(from.strutM[leg], to.strutM[leg], share);
        parts.wheelTurnDeg[leg] = turnDeg(mixedDeg(from.wheelTurnDeg[leg], to.wheelTurnDeg[leg], share));
    }
    return parts;
}

} // namespace

EntityState stateBetween(const EntityState& from, const EntityState& to, double share, double stepS)
{
    if (share >= 1.0 || from.isPresent != to.isPresent || isJump(from, to, stepS)) return to;
    EntityState state = to;
    state.position = glm::mix(from.position, to.position, share);
    state.velocity = glm::mix(from.velocity, to.velocity, share);
    state.headingDeg = signedDeg(mixedDeg(from.headingDeg, to.headingDeg, share));
    state.pitchDeg = mixed(from.pitchDeg, to.pitchDeg, share);
    state.rollDeg = signedDeg(mixedDeg(from.rollDeg, to.rollDeg, share));
    state.speedMps = mixed(from.speedMps, to.speedMps, share);
    state.odometerM = mixed(from.odometerM, to.odometerM, share);
    state.steeringDeg = mixed(from.steeringDeg, to.steeringDeg, share);
    state.wheelRotationDeg = turnDeg(mixedDeg(from.wheelRotationDeg, to.wheelRotationDeg, share));
    for (std::size_t wheel = 0; wheel < state.wheelTravelM.size(); ++wheel)
        state.wheelTravelM[wheel] = mixed(from.wheelTravelM[wheel], to.wheelTravelM[wheel], share);
    if (from.aircraft && to.aircraft) state.aircraft = partsBetween(*from.aircraft, *to.aircraft, share);
    return state;
}

} // namespace simulation
