// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <glm/glm.hpp>

namespace simulation
{

/// The wheels of AircraftParts, in their order.
enum GearLeg
{
    kNoseLeg,
    kLeftLeg,
    kRightLeg,
    kGearLegs
};

/// Where the moving parts of an aircraft are and which lights are on, for pictures.
/// Signs: edges of surfaces, as their names say. Units: degrees, metres, radians a second.
struct AircraftParts
{
    double elevatorDeg = 0.0;      ///< trailing edge down
    double leftAileronDeg = 0.0;   ///< trailing edge down
    double rightAileronDeg = 0.0;  ///< trailing edge down
    double rudderDeg = 0.0;        ///< trailing edge left
    double flapDeg = 0.0;          ///< trailing edge down
    double propellerTurnDeg = 0.0; ///< 0…360, in its sense of turning
    double propellerRadps = 0.0;
    double noseSteeringDeg = 0.0;                    ///< positive to the left
    std::array<glm::dvec3, kGearLegs> wheelBottom{}; ///< struts unloaded; entity's frame
    std::array<double, kGearLegs> strutM{};          ///< pressed in
    std::array<double, kGearLegs> wheelTurnDeg{};    ///< 0…360, forward
    bool hasNavigationLights = false, hasStrobes = false, hasBeacon = false, hasLandingLight = false;

    bool operator==(const AircraftParts&) const = default;
};

} // namespace simulation
