// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/DefaultAircraft.h"

#include <cmath>

namespace scenery
{

simulation::AircraftParts defaultAircraftParts(const simulation::EntityState& state, bool isDark)
{
    constexpr double kStandingMps = 0.3, kCruiseRadps = 250.0;
    simulation::AircraftParts parts;
    const bool isRunning = !state.isOnGround || std::abs(state.speedMps) > kStandingMps;
    parts.propellerRadps = isRunning ? kCruiseRadps : 0.0;
    parts.hasNavigationLights = isRunning || isDark;
    parts.hasStrobes = parts.hasBeacon = isRunning;
    parts.hasLandingLight = isRunning && state.isOnGround;
    return parts;
}

} // namespace scenery
