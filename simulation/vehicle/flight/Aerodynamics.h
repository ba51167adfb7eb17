// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/vehicle/flight/AirData.h"
#include "simulation/vehicle/flight/AircraftData.h"

namespace simulation
{

/// The surfaces as they stand. Radians; flaps in degrees. Positive: elevator's edge down, left aileron's edge
/// down, rudder's edge left.
struct SurfaceAngles
{
    double elevator = 0.0, aileron = 0.0, rudder = 0.0;
    double flapDeg = 0.0;
};

/// What the flow does besides its angles.
struct FlowState
{
    double stalled = 0.0;              ///< 0 attached … 1 separated
    double heightOverSpan = 10.0;      ///< of the wing above the ground
    double slipstreamPressurePa = 0.0; ///< dynamic pressure behind the propeller
};

/// A force and a moment about the centre of mass. Body axes; N, N m.
struct ForceMoment
{
    glm::dvec3 force{0.0};
    glm::dvec3 moment{0.0};

    ForceMoment& operator+=(const ForceMoment& other)
    {
        force += other.force;
        moment += other.moment;
        return *this;
    }
};

/// Forces of the air on the airframe, from the coefficients of the data file; beyond their range, those of a
/// plate, over the whole circle. `arm`: from the centre of mass to the aerodynamic point, body axes.
/// Source: Etkin, Reid, *Dynamics of Flight*, 3rd edition, 1996, chapters 4 and 5 (the build-up from
/// derivatives); Viterna, Corrigan,
/// *Fixed Pitch Rotor Performance of Large Horizontal Axis Wind Turbines*, 1982 (the plate).
ForceMoment aerodynamicForces(const AircraftData& aircraft, const AirData& air, const SurfaceAngles& surfaces,
                              const FlowState& flow, const glm::dvec3& arm);

} // namespace simulation
