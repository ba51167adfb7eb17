// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/player/actions/RunningAction.h"

namespace simulation
{

/// Who drives ahead on the same lane.
struct LeadVehicle
{
    int entity = -1;
    double gapM = 0.0; ///< between the boxes, along the road
};

/// Returns the nearest entity ahead of another one on its lane, no farther than `lookAheadM` and no farther
/// sideways than `lateralM`, or one that comes close in front of it from beside: the nearer end of its box
/// within 0.5 m to the right and 0.2 m to the left of the own box, and within a second or so of closing in.
/// Nothing: the road is free.
/// Source: what esmini 3.6 does with acc-test.
std::optional<LeadVehicle> leadVehicleOf(ActionScene& scene, int actor, double lookAheadM, double lateralM);

} // namespace simulation
