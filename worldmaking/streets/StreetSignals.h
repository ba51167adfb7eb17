// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/network/RoadNetwork.h>

#include "worldmaking/streets/BuildStreets.h"
#include "worldmaking/streets/SignalPlan.h"

namespace worldmaking
{

/// Adds the lights, signs, stop lines and lit crossings of a plan to a network whose road i is that of chain
/// i, and whose junction i is that of crossing i. Each place with lights has a controller, which its
/// junctions name; lights between crossings have one that no junction names.
/// An arm has a light (1000001) at its stop line, 0.6 m beside the paving; from two lanes on another one
/// above them. Who crosses on foot has a light (1000002) on either side, and stripes of 3 m; the stop line is
/// 1 m before them. Signs are 205 and 206 of the German catalogue. Sizes are chosen.
/// Source: ASAM OpenDRIVE 1.7, 14 (signals).
void addSignals(const SignalPlan& plan, osgRoads::core::RoadNetwork& network, StreetReport& report);

} // namespace worldmaking
