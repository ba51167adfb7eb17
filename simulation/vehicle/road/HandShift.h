// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/vehicle/road/RoadVehicle.h"

namespace simulation
{

/// A left foot and a right hand: shifts a manual gearbox by engine speed and works its clutch; an automatic
/// is left in its forward gear. Shifts earlier with little throttle.
class HandShift
{
public:
    /// Takes over from where a vehicle is.
    void begin(const RoadVehicle& vehicle);

    /// Sets clutch, gear and, while it shifts, throttle of the next step. `throttle`: what the right foot
    /// wants, 0…1.
    void control(const RoadVehicle& vehicle, double throttle, RoadInputs& inputs);

    /// The clutch's pedal at an engine speed: pressed at idle, released at about twice that.
    static double clutchAt(double rpm, const RoadEngineData& engine);

private:
    int chooseGear(const RoadVehicle& vehicle, double throttle) const;

    int _gear = 1;
    double _shiftS = 0.0; ///< left of a shift
};

} // namespace simulation
