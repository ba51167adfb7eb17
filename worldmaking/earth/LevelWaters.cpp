// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/earth/LevelWaters.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <ogr_geometry.h>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/query/Stations.h>

#include "scenery/buildings/Outline.h"
#include "worldmaking/earth/WaterWorks.h"
#include "worldmaking/map/GdalScope.h"
#include "worldmaking/map/OgrPieces.h"
#include "worldmaking/map/WaterTags.h"
#include "worldmaking/plan/PlanGrid.h"
#include "worldmaking/plan/Waters.h"

namespace worldmaking
{

namespace
{

using osgRoads::core::Road;

constexpr double kStripStepM = 5.0;
constexpr std::size_t kStripSteps = 10; ///< steps of one strip of a road
constexpr double kRoadBesideM =
    4.5; ///< from the lanes to where a triangle of the ground may leave the road's bed
constexpr double kBedEdgeM = 2.0; ///< from the edge of a river's bed to the water
constexpr double kLeastM2 = 20.0; ///< smaller pieces are left out
constexpr int kArcs = 4;          ///< of a round end, a quarter of a turn

/// A line of the plane with a width.
struct Band
{
    std::vector<glm::dvec2> line;
    double widthM = 0.0;
};

/// Bands that are found by their boxes.
class Bands
{
public:
    void add(Band band)
    {
        const MapBox box = boxOf(band.line);
        const glm::dvec2 beside(0.5 * band.widthM);
        _grid.add(_bands.size(), {box.low - beside, box.high + beside});
        _bands.push_back(std::move(band));
    }

    /// The bands near a box as one area; null: there are none.
    std::unique_ptr<OGRGeometry> near(const MapBox& box) const
    {
        OGRMultiPolygon bands;
        _grid.near(box,
                   [&](std::size_t i)
                   {
                       OGRLineString line;
                       for (const glm::dvec2& place : _bands[i].line)
                           line.addPoint(place.x, place.y);
                       const std::unique_ptr<OGRGeometry> band(line.Buffer(0.5 * _bands[i].widthM, kArcs));
                       if (band) bands.addGeometry(band.get());
                   });
        return std::unique_ptr<OGRGeometry>(bands.IsEmpty() ? nullptr : bands.UnionCascaded());
    }

private:
    std::vector<Band> _bands;
    PlanGrid _grid;
};

Bands riverBeds(std::span<const osgTerrainROAM::core::Earthwork> works)
{
    Bands beds;
    for (const auto& work : works)
        if (work.river > 0 && work.widthM > kBedEdgeM + 1.0 && work.paths.front().size() > 1)
            beds.add({work.paths.front(), work.widthM - kBedEdgeM});
    return beds;
}

/// Whether the ground carries a road here, or within a sample of it.
bool isOnGround(const Road& road, double s)
{
    const auto at = [&](double there) { return osgRoads::core::structureAt(road, there) != nullptr; };
    return !at(s) || !at(std::max(0.0, s - kRoadBesideM)) || !at(std::min(road.length, s + kRoadBesideM));
}

void addRoad(const Road& road, Bands& beds)
{
    Band band;
    const auto finish = [&]
    {
        if (band.line.size() > 1) beds.add(band);
        band = {};
    };
    for (const double s : osgRoads::core::evenStations(road.length, kStripStepM))
    {
        const auto lanes = osgRoads::core::extentAt(road, s);
        const glm::dvec2 place(osgRoads::core::surfacePoint(road, s, 0.5 * (lanes.leftT + lanes.rightT)));
        const double widthM = lanes.leftT - lanes.rightT + 2.0 * kRoadBesideM;
        band.line.push_back(place);
        band.widthM = std::max(band.widthM, widthM);
        if (!isOnGround(road, s))
        {
            band.line.pop_back();
            finish();
        }
        else if (band.line.size() > kStripSteps)
        {
            finish();
            band = {{place}, widthM};
        }
    }
    finish();
}

Bands roadBeds(const osgRoads::core::RoadNetwork& network)
{
    Bands beds;
    for (const Road& road : network.roads)
        if (road.isUsable) addRoad(road, beds);
    return beds;
}

/// What of a water is at its level; null: it is as a whole.
std::unique_ptr<OGRGeometry> levelPartOf(const LandShape& inPlane, const Bands& rivers, const Bands& roads)
{
    const MapBox box = boxOf(inPlane.paths.front());
    const auto beds = isRiverArea(inPlane.tags) ? rivers.near(box) : nullptr;
    const auto ground = roads.near(box);
    if (!beds && !ground) return nullptr;
    auto left = geometryOf(inPlane);
    if (left && beds) left.reset(left->Intersection(beds.get()));
    if (left && ground) left.reset(left->Difference(ground.get()));
    return left;
}

} // namespace

std::size_t cutToLevel(LandMap& map, const MapPlane& plane,
                       std::span<const osgTerrainROAM::core::Earthwork> works,
                       const osgRoads::core::RoadNetwork& network)
{
    const GdalScope quiet;
    const Bands rivers = riverBeds(works), roads = roadBeds(network);
    std::vector<LandShape> kept;
    kept.reserve(map.shapes.size());
    std::size_t gone = 0;
    for (LandShape& shape : map.shapes)
    {
        const auto rings = isWater(shape) ? plane.toPlan(shape.paths) : std::nullopt;
        const LandShape inPlane{shape.id, shape.form, rings.value_or(PlanRings()), shape.tags};
        const auto left = rings ? levelPartOf(inPlane, rivers, roads) : nullptr;
        if (!left)
        {
            kept.push_back(std::move(shape));
            continue;
        }
        std::vector<LandShape> pieces;
        addPieces(*left, inPlane, pieces);
        std::erase_if(pieces, [](const LandShape& piece) { return scenery::areaOf(piece.paths) < kLeastM2; });
        for (LandShape& piece : pieces)
            if (auto degrees = plane.toDegrees(piece.paths))
                kept.push_back({piece.id, piece.form, std::move(*degrees), std::move(piece.tags)});
        gone += pieces.empty() ? 1 : 0;
    }
    map.shapes = std::move(kept);
    return gone;
}

} // namespace worldmaking
