// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/vehicle/flight/AircraftData.h"

namespace simulation
{

/// What a propeller does at a speed of its own and of the air.
struct PropellerOutput
{
    double thrustN = 0.0;
    double torqueNm = 0.0;           ///< that it takes from the engine
    double inducedVelocityMps = 0.0; ///< in the disc
};

/// A propeller of fixed pitch from its coefficients over the advance ratio. `forwardMps`: along its axis.
/// Source: McCormick, *Aerodynamics, Aeronautics, and Flight Mechanics*, 2nd edition, 1995, section 6
/// (coefficients; momentum theory for the induced velocity). Limit: at rest in a wind from behind, the
/// coefficients of the advance ratio 0 hold.
PropellerOutput propellerOutput(const PropellerData& propeller, double speedRadps, double forwardMps,
                                double densityKgPerM3);

} // namespace simulation
