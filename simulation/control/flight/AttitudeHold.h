// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/control/flight/FlightSense.h"

namespace simulation
{

/// The three surfaces, as inputs of an aircraft: -1…1; nose down, right wing down, nose left.
struct SurfaceInputs
{
    double elevator = 0.0, aileron = 0.0, rudder = 0.0;
};

/// Holds pitch and bank with elevator and aileron, and the ball in the middle with the rudder.
/// Gains go down with the dynamic pressure, as the force of the surfaces goes up.
/// Source: Stevens, Lewis, *Aircraft Control and Simulation*, 2nd edition, 2003, sections 4.4 and 4.6 (pitch
/// and bank by attitude and rate, with an integral part; turn coordination).
class AttitudeHold
{
public:
    /// One step. `pitch`, `roll`: wanted, radians.
    SurfaceInputs step(const FlightSense& sense, double pitch, double roll, double stepS);

    /// Begins from an elevator input, so that nothing jumps.
    void reset(double elevator) { _elevator = elevator; }

private:
    double _elevator = 0.0, _aileron = 0.0; ///< what the integral parts hold
};

} // namespace simulation
