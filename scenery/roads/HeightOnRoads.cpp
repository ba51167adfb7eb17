// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/HeightOnRoads.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <osgRoads/core/place/RoadBed.h>
#include <osgRoads/core/place/TunnelTube.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

#include "scenery/roads/TunnelOpenings.h"

namespace scenery
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgRoads::core::RoadMatch;

constexpr double kOnLanesM = 1e-6;   ///< points that are less far from lanes lie on them
constexpr double kDeckBesideM = 0.5; ///< from the lanes of a bridge to the side of its deck

/// What counts before what within one level.
enum class Rank
{
    beside, ///< ground and verge
    lane,
    carriageway,
};

struct Surface
{
    double heightM = 0.0;
    Rank rank = Rank::beside;
};

Surface surfaceOf(const PlacedNetwork& roads, const RoadMatch& match)
{
    const auto& [index, s, t, h] = match.position;
    const double heightM = roads.surfaceAt(match, osgRoads::core::RoadBed{}).z;
    if (match.distance > kOnLanesM) return {heightM, Rank::beside};
    const auto span = osgRoads::core::laneAt(roads.road(index), s, t);
    const bool isForCars = span && osgRoads::core::isForCars(span->lane->type);
    return {heightM, isForCars ? Rank::carriageway : Rank::lane};
}

/// Adds what a road has at a place: a lane, its verge, a bridge's deck beside them, a tunnel's walkway.
void addSurface(const PlacedNetwork& roads, const RoadMatch& match, std::vector<Surface>& surfaces)
{
    const auto& [index, s, t, h] = match.position;
    const osgRoads::core::Road& road = roads.road(index);
    const auto* structure = osgRoads::core::structureAt(road, s);
    if (structure && structure->kind == osgRoads::core::StructureKind::tunnel)
    {
        const osgRoads::core::TunnelTube tube;
        const auto paved = osgRoads::core::pavedSides(road, s);
        const double edgeT = std::clamp(t, paved.right, paved.left), outM = std::fabs(t - edgeT);
        if (outM > kOnLanesM && outM <= tube.besideM)
        {
            surfaces.push_back({roads.surfacePoint(index, s, edgeT).z + tube.walkwayM, Rank::beside});
            return;
        }
        if (outM > tube.besideM) return; // there is hillside
    }
    const bool isOnDeck = structure && structure->kind == osgRoads::core::StructureKind::bridge &&
                          match.distance <= kDeckBesideM;
    if (match.distance <= kOnLanesM || !structure || isOnDeck) surfaces.push_back(surfaceOf(roads, match));
}

/// Returns the level on which something from a height stands.
double levelFor(const std::vector<Surface>& surfaces, double fromM)
{
    double highestBelow = -INFINITY, lowest = INFINITY;
    for (const Surface& surface : surfaces)
    {
        lowest = std::min(lowest, surface.heightM);
        if (surface.heightM <= fromM + kStepM) highestBelow = std::max(highestBelow, surface.heightM);
    }
    return std::isfinite(highestBelow) ? highestBelow : lowest;
}

} // namespace

double heightOnRoads(const PlacedNetwork& roads, const glm::dvec3& ground, double fromM)
{
    std::vector<Surface> surfaces;
    bool isOpen = false; // the ground lies in a tunnel's tube, where there is none
    const glm::dvec2 plan(roads.toInertial(ground));
    for (const RoadMatch& match : roads.locator().within(plan, osgRoads::core::RoadBed{}.vergeM))
    {
        addSurface(roads, match, surfaces);
        isOpen = isOpen || isInTunnel(roads, match, ground.z);
    }
    // Ground that a lane covers is its bed, or, for something of unknown height, the hill above its tunnel.
    const bool isCovered =
        std::any_of(surfaces.begin(), surfaces.end(),
                    [&](const Surface& surface)
                    {
                        return surface.rank > Rank::beside &&
                               (!std::isfinite(fromM) || std::fabs(surface.heightM - ground.z) < kLevelM);
                    });
    if (surfaces.empty() || !(isCovered || isOpen)) surfaces.push_back({ground.z, Rank::beside});
    const double levelM = levelFor(surfaces, fromM);
    Surface best{-INFINITY, Rank::beside};
    for (const Surface& surface : surfaces)
    {
        if (std::fabs(surface.heightM - levelM) >= kLevelM) continue;
        if (surface.rank > best.rank || (surface.rank == best.rank && surface.heightM > best.heightM))
            best = surface;
    }
    return best.heightM;
}

} // namespace scenery
