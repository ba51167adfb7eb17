// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/CutRoads.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/Stations.h>
#include <osgTerrainROAM/core/edit/HeightRule.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include "scenery/roads/RoadEdges.h"

namespace scenery
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgRoads::core::Road;
using osgTerrainROAM::core::EditDetail;
using osgTerrainROAM::core::PlacedTile;
using osgTerrainROAM::core::PlanBox;

constexpr double kBoxStepM = 15.0;
constexpr double kEarthworkMarginM =
    2.0; ///< by which earthworks may be larger between the places that are looked at
constexpr double kLeastRiseM = 0.05; ///< smaller ones are left out

/// Where tunnels of a network come out. Frame: the scene's, x and y.
std::vector<glm::dvec2> portalsOf(const PlacedNetwork& roads)
{
    std::vector<glm::dvec2> portals;
    for (int i = 0; i < static_cast<int>(roads.network().roads.size()); ++i)
        for (const auto& structure : roads.road(i).structures)
            if (roads.road(i).isUsable && structure.kind == osgRoads::core::StructureKind::tunnel)
                for (const double s : {structure.s, structure.s + structure.length})
                    portals.emplace_back(roads.surfacePoint(i, std::min(s, roads.road(i).length), 0.0));
    return portals;
}

/// The box of one station: its lanes, and as far beside them as cutting or embankment may reach. False:
/// beyond the data.
bool boxAt(const PlacedTile& tile, const PlacedNetwork& roads, int road, double s, const RoadCutShape& shape,
           PlanBox& box)
{
    const auto lanes = osgRoads::core::extentAt(roads.road(road), s);
    double earthworkM = 0.0;
    bool isOnTile = false;
    box = {glm::dvec2(1e300), glm::dvec2(-1e300)};
    for (const double t : {lanes.rightT, 0.5 * (lanes.rightT + lanes.leftT), lanes.leftT})
    {
        const glm::dvec3 place = roads.surfacePoint(road, s, t);
        box.low = glm::min(box.low, glm::dvec2(place));
        box.high = glm::max(box.high, glm::dvec2(place));
        const auto ground = osgTerrainROAM::core::groundAt(tile, place.x, place.y);
        if (!ground) continue;
        isOnTile = true;
        earthworkM = std::max(earthworkM, std::abs(ground->position.z - place.z));
    }
    const double besideM = shape.bed.vergeM + RoadEdges::reachOf(earthworkM + kEarthworkMarginM, shape);
    box = box.grownBy(besideM + 0.5 * kBoxStepM);
    return isOnTile;
}

std::vector<PlanBox> boxesOf(const PlacedTile& tile, const PlacedNetwork& roads, const RoadCutShape& shape)
{
    std::vector<PlanBox> boxes;
    for (int i = 0; i < static_cast<int>(roads.network().roads.size()); ++i)
    {
        const Road& road = roads.road(i);
        if (!road.isUsable) continue;
        for (const double s : osgRoads::core::evenStations(road.length, kBoxStepM))
        {
            PlanBox box;
            if (boxAt(tile, roads, i, s, shape, box)) boxes.push_back(box);
        }
    }
    return boxes;
}

} // namespace

foundation::Result<osgTerrainROAM::core::EditReport> cutRoads(osgTerrainROAM::core::TileEditor& editor,
                                                              const PlacedNetwork& roads,
                                                              const RoadCutShape& asked,
                                                              const osgTerrainROAM::core::Earthworks* water)
{
    const PlacedTile& tile = editor.tile().tile;
    RoadCutShape shape = asked;
    shape.sampleM = std::max(tile.field().spacingEastM, tile.field().spacingNorthM) / tile.grid().cellSide();
    shape.torn = std::make_shared<const TornRoads>(roads.network());
    const auto boxes = boxesOf(tile, roads, shape);
    if (boxes.empty())
        return foundation::Error{tile.field().name, "the roads lie beyond the terrain",
                                 "state where they lie: roads_origin = LAT LON [HEADING]"};
    const RoadEdges edges(roads, tile, shape);
    const std::vector<glm::dvec2> portals = portalsOf(roads);
    const double portalM = 2.0 * shape.reachM;
    const auto rule = [&](const glm::dvec2& place, double heightM)
    {
        const glm::dvec2 grid = tile.frame().gridNear(place);
        const double z = tile.frame().positionAt(grid.x, grid.y, heightM).z;
        const bool isByPortal =
            std::any_of(portals.begin(), portals.end(),
                        [&](const glm::dvec2& portal)
                        { return glm::dot(portal - place, portal - place) < portalM * portalM; });
        const HeightBand band = roadBand(roads, tile.frame(), shape, glm::dvec3(place, z),
                                         isByPortal ? shape.reachM : shape.structureM);
        if (band.isBed) return band.nearestTo(heightM);
        const double riseM = edges.riseAt(place);
        if (water && std::abs(riseM) >= kLeastRiseM && water->bedM(place)) return band.nearestTo(heightM);
        return band.nearestTo(std::abs(riseM) < kLeastRiseM ? heightM : heightM + riseM);
    };
    const bool isFine = tile.grid().exponent() > 0;
    const auto changes =
        osgTerrainROAM::core::changesBy(rule, tile, boxes, isFine ? EditDetail::places : EditDetail::samples);
    if (!changes) return changes.error();
    using Between = osgTerrainROAM::core::TileEditor::Between;
    auto report = editor.apply(*changes, isFine ? Between::stays : Between::follows);
    editor.forgetUndo();
    return report;
}

} // namespace scenery
