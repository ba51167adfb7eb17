// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"

namespace worldmaking
{

/// Parks aircraft on the aprons and helipads of a map: on its parking positions (aeroway=parking_position,
/// nose at the end of a line), and on an apron that has none in rows along its long sides; some places stay
/// free. Airliners stand on aprons of 80 m and more at a runway of 1 800 m and more, light aircraft on all
/// others, helicopters on helipads. None stands nearer than a few metres to a taxiway, a building or another.
/// Returns points that name models, as writeModels() takes them. The same map gives the same aircraft.
std::vector<LandShape> parkedAircraft(const LandMap& map, const MapPlane& plane);

} // namespace worldmaking
