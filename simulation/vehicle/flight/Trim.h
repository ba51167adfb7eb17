// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <foundation/Result.h>

#include "simulation/vehicle/EarthFrame.h"
#include "simulation/vehicle/flight/FlightModel.h"

namespace simulation
{

/// A steady flight to find. Angles in degrees.
struct TrimTarget
{
    glm::dvec3 position{0.0}; ///< scene
    double headingDeg = 0.0;
    double trueAirspeedMps = 50.0;
    double pathDeg = 0.0;           ///< climb angle; ignored with a throttle
    std::optional<double> throttle; ///< given: the climb angle is found
    double bankDeg = 0.0;           ///< of a turn; 0: straight without sideslip
    double flapDeg = 0.0;
    double mixture = 1.0;
};

/// A state and the inputs that keep it. The elevator's command stands on the trim tab.
struct TrimmedFlight
{
    FlightState state;
    FlightInputs inputs = runningInputs();
    double pathDeg = 0.0;
};

/// Finds the steady flight: angle of attack, bank or sideslip, surfaces, throttle or climb angle, and engine
/// speed for which neither velocity nor rates change, by Newton's method on seven equations.
/// `air`: at the position. `fuelKg` as the data file has it.
/// Errors: no such flight within the travel of the controls (stall, too fast, too little power), naming what
/// was wanting.
/// Source: Stevens, Lewis, *Aircraft Control and Simulation*, 2nd edition, 2003, section 3.6.
foundation::Result<TrimmedFlight> trim(const AircraftData& aircraft, const EarthFrame& earth,
                                       const AirSample& air, const TrimTarget& target);

} // namespace simulation
