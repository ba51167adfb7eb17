// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osgRoads/core/network/RoadNetwork.h>

namespace simulation
{

/// A line on a road where traffic may have to stop.
struct RoadStop
{
    double sM = 0.0;
    std::string signal; ///< id of the traffic light; empty: a stop sign
};

/// Returns the stop signs and traffic lights of a road that hold for a lane in a direction, between two
/// places of it, in the order in which they are met. Signs are those of the German and Swedish catalogues
/// (206, B 2), lights those of OpenDRIVE (1000001); a signal without validities holds for all lanes. Signals
/// that a road takes over from another one (signalReference) count as its own. Frame: s of the road, metres.
/// Source: ASAM OpenDRIVE 1.8, 14 (signals).
std::vector<RoadStop> stopsBetween(const osgRoads::core::RoadNetwork& network, int road, int lane,
                                   double fromM, double toM);

/// Whether there is any stop sign.
bool hasStopSigns(const osgRoads::core::RoadNetwork& network);

/// Whether a traffic light lets pass: a word with green, `go`, `off`, or the last of its lamps is `on`
/// (`off;off;on`).
bool letsPass(const std::string& state);

} // namespace simulation
