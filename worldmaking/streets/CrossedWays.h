// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"
#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/StreetGraph.h"

namespace worldmaking
{

/// What a street or a railway crosses that has a height of its own.
enum class CrossedKind : std::uint8_t
{
    path, ///< for walkers, riders and tractors
    water,
    airway, ///< a runway or taxiway
};

/// Where one passes over or under such a thing. Units: metres.
struct CrossedPlace
{
    CrossedKind kind = CrossedKind::path;
    std::size_t chain = 0;
    double alongM = 0.0;   ///< the centre line of the street
    double halfM = 0.0;    ///< along it, what the thing takes to either side
    glm::dvec2 place{0.0}; ///< in the plan
    bool isStreetAbove = true;
    double apartM = 0.0;  ///< wanted, from the ground at the place to the street
    std::int64_t way = 0; ///< of the map
};

/// Finds where bridges of streets and railways pass over paths, lines and areas of water, ways without a
/// bridge over rivers and canals, and where they pass under runways and taxiways. Ways with a point in common
/// meet at one level, and are left out; so are culverts: a stream below a street without a bridge.
/// Cost: near-linear (a grid). `places`: of the map's nodes.
std::vector<CrossedPlace> crossedPlaces(const StreetGraph& graph, const std::vector<glm::dvec2>& places,
                                        const std::vector<CentreLine>& lines, const LandMap& land,
                                        const MapPlane& plane);

} // namespace worldmaking
