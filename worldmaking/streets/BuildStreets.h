// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <foundation/Heights.h>
#include <foundation/Result.h>

#include <osgRoads/core/network/RoadNetwork.h>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/StreetMap.h"
#include "worldmaking/streets/Footbridges.h"
#include "worldmaking/streets/Track.h"

namespace worldmaking
{

/// What became of a map's streets.
struct StreetReport
{
    std::size_t ways = 0, closedWays = 0, waysBeyondGround = 0;
    std::size_t missingNodes = 0, shortWays = 0;
    std::size_t streets = 0, crossings = 0, turns = 0;
    std::size_t bridges = 0, tunnels = 0, overpasses = 0, lostOverpasses = 0, overpassesLeftOpen = 0;
    std::size_t impliedBridges = 0; ///< where no ground can carry a street
    std::size_t sharpBends = 0;     ///< streets with a bend that is narrower than half their paving
    std::size_t litPlaces = 0;      ///< crossings, or groups of them, and places between that have lights
    std::size_t trafficLights = 0, waitSigns = 0; ///< waitSigns: to stop and to give way
    double lengthKm = 0.0;                        ///< of streets, without crossings
    double steepestPercent = 0.0;
    double steepKm = 0.0;                       ///< steeper than their class allows: the map leaves no room
    std::size_t tracks = 0, levelCrossings = 0; ///< chains of railways; where streets meet them
    std::size_t coveredCrossings = 0; ///< bridges and tunnels that the map lacks over and under other things
    std::size_t bareTunnels = 0;      ///< that stand above the ground
    std::vector<std::string> notes;   ///< what could not be made as the map has it (CrossingNotes.h)
};

struct Streets
{
    osgRoads::core::RoadNetwork network;
    std::vector<Track> tracks;           ///< in the plan of the network
    std::vector<Footbridge> footbridges; ///< likewise, with their ramps
    StreetReport report;
};

/// Makes an OpenDRIVE network of the streets of a map on a ground: smooth centre lines, lanes by tags,
/// crossings with a connecting road for each turn, bridges and tunnels where the map has them, heights within
/// the grades of each class.
/// `land`: what else the map has; its railways get heights of their own, and streets pass over and under
/// them, paths, water and runways.
/// Frame: transverse Mercator about the middle of the map (in the header as geoReference); heights as
/// `ground` counts them. Ways of which a node lies beyond the ground are left out, and counted.
/// Errors: nothing of the map lies on the ground; PROJ.
/// Cost: about 1 s for 500 km. Same input, same bytes.
foundation::Result<Streets> buildStreets(const StreetMap& map, const foundation::HeightOnEarth& ground,
                                         const std::string& mapName, const LandMap* land = nullptr);

} // namespace worldmaking
