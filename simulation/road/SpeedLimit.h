// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/road/RoadScene.h"

namespace simulation
{

/// Returns the speed limit in m/s at a place: that of its lane, else that of its road; nothing: none is told.
/// Source: ASAM OpenDRIVE 1.8, 10.4.2 (road type), 11.8.4 (speed of a lane).
std::optional<double> speedLimitAt(const RoadScene& roads, const RoadPlace& place);

} // namespace simulation
