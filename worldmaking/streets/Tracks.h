// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <foundation/Heights.h>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/streets/CentreLine.h"
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

/// The height of the street whose lanes lie at a place, of those on the ground, on bridges or in tunnels the
/// one nearest to a height; nothing: no lanes.
using StreetSurface =
    std::function<std::optional<double>(const glm::dvec2& place, StreetPlace on, double nearM)>;

/// Returns the traits of a railway: its grade, its level, a contact wire. Nothing for what is not drawn.
/// Source of grades: German EBO, section 7, 40 per mille on branch lines, 12.5 on main lines, which lie on
/// ground that is coarser than they are, so 25 here; trams climb as streets do (BOStrab).
std::optional<StreetTraits> trackTraitsOf(const Tags& tags);

/// Returns the railways of a map as ways whose ids are the numbers of their shapes. `nodes`: of the streets;
/// those of railways are added, one for both where they have it in common. Ways off the ground are left out.
StreetMap tracksOf(const LandMap& land, const std::vector<MapNode>& nodes,
                   const foundation::HeightOnEarth& ground);

/// Makes cuttings of tunnels up to 60 m that no hill covers: a railway that passes under a street is seen
/// there. `places`: of nodes.
void openShortTunnels(StreetGraph& tracks, const std::vector<glm::dvec2>& places,
                      const foundation::HeightInPlan& ground);

/// Returns both as one graph: chains and crossings of `tracks` after those of `streets`.
StreetGraph joined(const StreetGraph& streets, const StreetGraph& tracks);

/// Finds where streets and railways have a point in common. `tracks`: the first chain of a railway.
std::vector<LevelPlace> levelPlaces(const StreetGraph& graph, std::size_t tracks,
                                    const std::vector<CentreLine>& lines);

/// What tracks are cut from. All must outlive the call.
struct TrackSources
{
    const StreetGraph& graph;
    std::size_t tracks; ///< the first chain of a railway
    const std::vector<CentreLine>& lines;
    const std::vector<glm::dvec2>& places; ///< of nodes
    const StreetHeights& heights;
    const std::vector<TrackSpan>& spans;
    const foundation::HeightInPlan& ground; ///< in the plan
    const StreetSurface& streetAt;
};

/// Cuts railways into stretches by way, bridge, tunnel and street, and puts rails flush with the street: at
/// level crossings, and those of trams wherever they run in lanes. Tracks beside each other share a tube.
std::vector<Track> tracksWithHeights(const TrackSources& from);

} // namespace worldmaking
