// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "simulation/scenario/Entity.h"
#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// Returns the entity that moves along a recorded track, with a usual size for its kind. Units: metres.
ScenarioObject entityOf(TrackKind kind, const std::string& name);

/// The speed at which a track without times is followed, m/s.
double defaultSpeedMps(TrackKind kind);

} // namespace simulation
