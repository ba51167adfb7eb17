// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/TunnelOpenings.h"

#include <algorithm>
#include <cmath>

#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/query/Stations.h>

namespace scenery
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgRoads::core::RoadStructure;
using osgRoads::core::TunnelTube;
using osgTerrainROAM::core::GroundOpening;

constexpr double kSectionEveryM =
    5.0; ///< the chord of a bend of 50 m is 6 cm off, a fifth of what the lining hides
constexpr double kOverFeetM = 0.5, kEndsM = 0.05;

GroundOpening::Section sectionOf(const PlacedNetwork& roads, int road, double s, const TunnelTube& tube)
{
    const auto sides = osgRoads::core::tunnelSides(roads.road(road), s, tube);
    return {roads.surfacePoint(road, s, sides.middle()), sides.half() + 0.5 * tube.liningM};
}

} // namespace

GroundOpening emptyOpening(const TunnelTube& tube)
{
    GroundOpening opening;
    opening.lowM = tube.feetM + kOverFeetM;
    opening.wallM = tube.wallM + 0.25 * tube.liningM;
    opening.kneeM = tube.kneeM + 0.5 * tube.liningM;
    opening.crownM = tube.crownM + 0.5 * tube.liningM;
    opening.beyondM = kEndsM;
    return opening;
}

std::vector<GroundOpening> tunnelOpenings(const PlacedNetwork& roads, const TunnelTube& tube)
{
    std::vector<GroundOpening> openings;
    for (int i = 0; i < static_cast<int>(roads.network().roads.size()); ++i)
    {
        const auto& road = roads.road(i);
        if (!road.isUsable) continue;
        for (const RoadStructure& structure : road.structures)
        {
            if (structure.kind != osgRoads::core::StructureKind::tunnel) continue;
            const double from = std::max(structure.s - tube.portalM, 0.0);
            const double to = std::min(structure.s + structure.length + tube.portalM, road.length);
            if (to - from < tube.portalM) continue;
            GroundOpening opening = emptyOpening(tube);
            for (const double along : osgRoads::core::evenStations(to - from, kSectionEveryM))
                opening.line.push_back(sectionOf(roads, i, from + along, tube));
            openings.push_back(std::move(opening));
        }
    }
    return openings;
}

bool isInTunnel(const PlacedNetwork& roads, const osgRoads::core::RoadMatch& match, double heightM,
                const TunnelTube& tube)
{
    const auto& at = match.position;
    const auto* structure = osgRoads::core::structureAt(roads.road(at.road), at.s);
    if (!structure || structure->kind != osgRoads::core::StructureKind::tunnel) return false;
    const auto sides = osgRoads::core::tunnelSides(roads.road(at.road), at.s, tube);
    const double aside = std::fabs(at.t - sides.middle()) / (sides.half() + 0.5 * tube.liningM);
    if (aside > 1.0) return false;
    const GroundOpening opening = emptyOpening(tube);
    const double overM = heightM - roads.surfacePoint(at.road, at.s, sides.middle()).z;
    return overM >= opening.lowM && overM < opening.roofM(aside);
}

} // namespace scenery
