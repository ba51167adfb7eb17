// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/GroundOnEarth.h"
#include "worldmaking/streets/StreetGraph.h"
#include "worldmaking/streets/StreetHeights.h"
#include "worldmaking/streets/Track.h"

namespace worldmaking
{

/// A bridge of a railway that the map does not tell, along a chain.
struct TrackSpan
{
    std::size_t chain = 0;
    double fromM = 0.0, toM = 0.0;
};

/// Returns the traits of a railway that has heights of its own: its grade, its level, a contact wire. Nothing
/// for trams, which run in streets, and for what is not drawn.
/// Source of grades: German EBO, section 7, 40 per mille on branch lines, 12.5 on main lines, which lie on
/// ground that is coarser than they are, so 25 here; BOStrab.
std::optional<StreetTraits> trackTraitsOf(const Tags& tags);

/// Returns the railways of a map as ways whose ids are the numbers of their shapes. `nodes`: of the streets;
/// those of railways are added, one for both where they have it in common. Ways off the ground are left out.
StreetMap tracksOf(const LandMap& land, const std::vector<MapNode>& nodes, const GroundOnEarth& ground);

/// Makes cuttings of tunnels up to 60 m that no hill covers: a railway that passes under a street is seen
/// there. `places`: of nodes.
void openShortTunnels(StreetGraph& tracks, const std::vector<glm::dvec2>& places, const GroundHeight& ground);

/// Returns both as one graph: chains and crossings of `tracks` after those of `streets`.
StreetGraph joined(const StreetGraph& streets, const StreetGraph& tracks);

/// Finds where streets and railways have a point in common. `tracks`: the first chain of a railway.
std::vector<LevelPlace> levelPlaces(const StreetGraph& graph, std::size_t tracks,
                                    const std::vector<CentreLine>& lines);

/// Cuts railways into stretches by way, bridge and tunnel, and puts the rails of level crossings flush with
/// the street. `ground`: in the plan.
std::vector<Track> tracksWithHeights(const StreetGraph& graph, std::size_t tracks,
                                     const std::vector<CentreLine>& lines,
                                     const std::vector<glm::dvec2>& places, const StreetHeights& heights,
                                     const std::vector<TrackSpan>& spans, const GroundHeight& ground);

} // namespace worldmaking
