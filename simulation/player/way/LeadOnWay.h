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
};

/// Returns the entities that stand or move where a vehicle is about to drive, up to `aheadM` before its
/// front, the nearest first: any part of a box counts that reaches into the strip that the vehicle needs. Of
/// those that keep the rules, too, whoever comes along the other lane does not count.
std::vector<LeadOnWay> leadsOnWay(ActionScene& scene, int actor, const DrivenWay& way,
                                  const JunctionKeeper& keeper, double aheadM);

} // namespace simulation
