// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
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

/// Whether a signal is a traffic light for vehicles: 1000001, and with fewer lamps or arrows in them 1000009
/// to 1000012 of OpenDRIVE. Source: ASAM OpenDRIVE 1.8, 14 (signals).
bool isTrafficLight(const osgRoads::core::Signal& signal);

/// Returns the stop signs and traffic lights of a road that hold for a lane in a direction, between two
/// places of it, in the order in which they are met. Signs are those of the German and Swedish catalogues
/// (206, B 2), lights by isTrafficLight(); a signal without validities holds for all lanes, one with an arrow
/// for all turns. Signals that a road takes over from another one (signalReference) count as its own. Frame:
/// s of the road, metres.
/// Source: ASAM OpenDRIVE 1.8, 14 (signals).
std::vector<RoadStop> stopsBetween(const osgRoads::core::RoadNetwork& network, int road, int lane,
                                   double fromM, double toM);

/// Whether there is any stop sign.
bool hasStopSigns(const osgRoads::core::RoadNetwork& network);

/// Whether a traffic light is dark, so that signs and rules hold in its place.
bool isSwitchedOff(const std::string& state);

/// Whether a traffic light is amber alone: it has let pass, and will not.
bool isAmber(const std::string& state);

/// Whether a traffic light lets pass: a word with green, `go`, `off`, or the last of its lamps is `on`
/// (`off;off;on`).
bool letsPass(const std::string& state);

/// Whether a traffic light stops those who come, by the states of all lights by id; one without a state lets
/// pass.
bool holdsBack(const std::map<std::string, std::string>& states, const std::string& signal);

} // namespace simulation
