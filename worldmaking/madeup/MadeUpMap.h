// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <foundation/Heights.h>
#include <foundation/Result.h>

#include "worldmaking/land/Runways.h"
#include "worldmaking/map/LandMap.h"
#include "worldmaking/streets/BuildStreets.h"

namespace worldmaking
{

/// By what a map is made up.
struct MadeUpSettings
{
    std::uint64_t seed = 1;
    double aridity = 0.12;     ///< 0 wet … 1 desert, which has hardly any woods and fields
    double treeLineM = 2000.0; ///< of the place; summits below it are bare, too
    MapBounds bounds;          ///< the part of the ground to fill
};

/// Something of a made-up map that one may look for: town, village, hamlet, airfield, lake, bridge.
struct MadeUpPlace
{
    std::string_view kind;
    glm::dvec2 degrees{0.0}; ///< east and north, of its middle
};

/// What was made up, by number.
struct MadeUpReport
{
    std::size_t settlements = 0, unreached = 0; ///< unreached: no way leads to them on feasible grades
    std::size_t farms = 0, houses = 0, fields = 0, hedges = 0, woods = 0, lakes = 0, bridges = 0,
                airfields = 0;
    double areaKm2 = 0.0, roadsKm = 0.0;
};

/// A map of a place that has none, as a reader of maps would give it, and its runways.
struct MadeUpMap
{
    LandMap land; ///< with the streets as lines
    std::vector<Runway> runways;
    std::vector<MadeUpPlace> places; ///< the town first
    MadeUpReport report;
    bool hasSea = false;    ///< at height 0
    double treeLineM = 0.0; ///< above which no tree stands
};

/// Makes up a map over a ground: an airfield on the gentlest, lakes, a town, villages, hamlets and farms on
/// gentle ground near water, roads between them on feasible grades, streets with houses, fields along the
/// relief, hedges, orchards, woods on slopes and along streams. `ground` is asked in many threads at once.
/// The same ground and seed give the same map. At most kLargestKm a side: of a larger ground the part with
/// the most gentle land is filled.
/// Errors: bounds without ground; ground without a place for a road; PROJ. Cost: some 10 s for 600 km².
foundation::Result<MadeUpMap> makeUpMap(const foundation::HeightOnEarth& ground,
                                        const MadeUpSettings& settings);

inline constexpr double kLargestKm = 26.0;

} // namespace worldmaking
