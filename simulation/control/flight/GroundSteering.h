// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/control/flight/RunwayStrip.h"

namespace simulation
{

/// Pedals that keep an aircraft on a line while it rolls: they turn it as fast as the line asks, whether the
/// rudder or the nose wheel does it, and never so fast that it would tip over.
class GroundSteering
{
public:
    /// -1…1, positive to the left.
    double step(const FlightSense& sense, const CourseLine& line, double stepS);

    /// Begins from pedals that are held.
    void reset(double pedals) { _held = pedals; }

private:
    double _held = 0.0; ///< the integral part
};

/// The part of the wind that comes from the right of a line.
double windFromRightMps(const FlightSense& sense, const CourseLine& line);

/// The aileron that keeps the wing down on the side that the wind comes from, less and less with the speed.
double aileronIntoWind(const FlightSense& sense, const CourseLine& line);

} // namespace simulation
