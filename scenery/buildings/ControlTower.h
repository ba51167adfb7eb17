// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/buildings/Building.h"

namespace scenery
{

/// Returns what the control tower of an airfield consists of: a shaft with windows, a gallery, a cab with
/// glass all around that is wider than the shaft, and its roof. The outline of the map is that of the cab.
/// A building that is lower than three storeys, wider than 18 m or not convex stays one part, with glass
/// around its highest storey.
std::vector<StandingBuilding> partsOfControlTower(const StandingBuilding& tower);

} // namespace scenery
