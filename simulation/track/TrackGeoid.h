// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// Makes heights of tracks count from the ellipsoid: those above mean sea level, and pressure altitudes,
/// which stand for such, are raised by the geoid, that of the file where it has one, else EGM96 as the
/// terrain's. Heights above the ground stay. FlightTrack::geoidM tells the mean; what has it is not raised
/// again.
/// Returns a line for the user where PROJ has no grid of the geoid: heights then stay as they are, up to
/// 107 m off.
/// Cost: one look-up for each fix.
std::optional<std::string> countFromEllipsoid(std::vector<FlightTrack>& tracks);

/// Takes all heights of tracks as counted from `datum`, whatever their format says.
void setDatum(std::vector<FlightTrack>& tracks, HeightDatum datum);

/// Returns the geoid above the ellipsoid at a place; 0 where PROJ has no grid. Units: degrees, metres.
double geoidHeightM(double latitudeDeg, double longitudeDeg);

} // namespace simulation
