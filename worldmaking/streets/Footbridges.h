// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <foundation/Heights.h>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"
#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/Mouths.h"
#include "worldmaking/streets/StreetHeights.h"
#include "worldmaking/streets/Tracks.h"

namespace worldmaking
{

/// A bridge for walkers, riders and tractors, or the stairs or ramp to one. Units: metres in the plan and in
/// the datum of the ground.
struct Footbridge
{
    std::int64_t way = 0; ///< of the map, the first of several
    bool isRamp = false;
    std::vector<glm::dvec2> points;
    std::vector<double> heightsM; ///< of its surface at each point
    double widthM = 2.5;
    std::vector<double> piersM; ///< along it, clear of what passes below
    int treads = 0;             ///< of stairs; 0: a ramp or a bridge
};

struct Footbridges
{
    std::vector<Footbridge> made; ///< bridges and ramps
    std::vector<std::string> notes;
};

/// What footbridges are made from. All must outlive the call.
struct FootbridgeSources
{
    const StreetGraph& graph; ///< streets and railways, with their heights
    const std::vector<glm::dvec2>& places;
    const std::vector<CentreLine>& lines;
    const std::vector<ChainCut>& cuts;
    const StreetHeights& heights;
    const LandMap& land;
    const MapPlane& plane;
    const foundation::HeightInPlan& ground;
    const StreetSurface& streetAt;
};

/// Makes the bridges of paths, of tracks, and of streets that are closed to cars. A bridge leads straight
/// from one end to the other, and higher where it must keep clear of streets (4.5 m), railways, paths (2.5 m)
/// and water (0.9 m) below it. Where its ends come to lie above the ground, a ramp leads down along the path
/// that goes on there, as gentle as there is room for, or else stairs; a way that is stairs falls by a half.
/// Stairs have as many treads as the map says of the way (`step_count`), where these are 10 to 25 cm high,
/// else some of 17 cm. Notes tell what has no room.
/// Cost: near-linear (a grid).
Footbridges footbridgesOf(const FootbridgeSources& from);

} // namespace worldmaking
