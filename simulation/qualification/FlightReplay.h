// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "simulation/qualification/ReferenceFlight.h"
#include "simulation/vehicle/flight/Aircraft.h"

namespace simulation
{

/// A part of a flight, by its time in seconds.
struct FlightWindow
{
    double startS = 0.0, endS = 0.0;
};

/// Flies an aircraft from the first state of a window of a recorded flight, with its inputs, in still
/// standard air. Returns a row for each row of the window; fewer where the aircraft fails. `mixture`: as in
/// the record, which does not have it.
Flight replay(const std::shared_ptr<const AircraftData>& aircraft, const Flight& reference,
              const FlightWindow& window, double mixture);

/// The rows of a window.
Flight rowsOf(const Flight& flight, const FlightWindow& window);

/// A flight's row as an aircraft has it now. Attitude and climb are about the geocentric vertical, as JSBSim
/// 2020.3 logs them.
FlightRow rowOf(const Aircraft& aircraft, double timeS);

} // namespace simulation
