// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/player/actions/RunningAction.h"
#include "simulation/player/way/DrivenWay.h"
#include "simulation/player/way/JunctionKeeper.h"

namespace simulation
{

/// Who is on the way of a vehicle, ahead of it.
struct LeadOnWay
{
    int entity = -1;
    double rearM = 0.0;    ///< its nearest part, along the way
    double gapM = 0.0;     ///< from the front of the vehicle
    double speedMps = 0.0; ///< along the way; negative: it comes nearer
    double lengthM = 0.0;  ///< of its box
    bool isAlong = true;   ///< it looks along the way, so that it goes on before the vehicle
};

/// Returns the entities whose bodies a vehicle would meet where they are now, up to `aheadM` along its way,
/// the nearest first: each place that its own body takes on the way is compared with their boxes, wherever
/// they stand, and whether they keep rules or not.
std::vector<LeadOnWay> leadsOnWay(ActionScene& scene, int actor, const DrivenWay& way,
                                  const JunctionKeeper& keeper, double aheadM);

} // namespace simulation
