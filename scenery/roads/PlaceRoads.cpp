// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/PlaceRoads.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>
#include <foundation/Earth.h>

#include <osgRoads/core/query/GeoReference.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/read/ReadNetwork.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include "scenery/roads/SceneDatum.h"
#include "scenery/roads/TornRoads.h"

namespace scenery
{

namespace
{

using osgRoads::core::GeoReference;
using osgRoads::core::Road;
using osgRoads::core::RoadNetwork;
using osgTerrainROAM::core::PlacedTile;
using osgTerrainROAM::core::Placement;

constexpr double kExtentStepM = 20.0;

/// A place of the tile at a height in the datum of its samples.
glm::dvec3 onTile(const PlacedTile& tile, double latitudeDeg, double longitudeDeg, double heightM)
{
    const auto& frame = tile.frame();
    const glm::dvec2 grid = frame.gridAt(frame.localFromGeodetic({latitudeDeg, longitudeDeg, 0.0}));
    return frame.positionAt(grid.x, grid.y, heightM);
}

/// About a stated origin metres of the file are metres along meridian and parallel; off by (distance /
/// Earth's radius)².
PlanMap::Place placeByOrigin(const PlacedTile& tile, const RoadOrigin& origin)
{
    constexpr double kA = foundation::kWgs84RadiusM, kE2 = foundation::kWgs84Eccentricity2;
    const double sine = std::sin(foundation::radiansOf(origin.latitudeDeg));
    const double w = std::sqrt(1.0 - kE2 * sine * sine);
    const double meridianM = kA * (1.0 - kE2) / (w * w * w), normalM = kA / w;
    const double heading = foundation::radiansOf(origin.headingDeg);
    return [&tile, origin, meridianM, normalM, heading](const glm::dvec2& plan,
                                                        double heightM) -> foundation::Result<glm::dvec3>
    {
        const double east = plan.x * std::cos(heading) + plan.y * std::sin(heading);
        const double north = plan.y * std::cos(heading) - plan.x * std::sin(heading);
        const double latitudeDeg = origin.latitudeDeg + foundation::degreesOf(north / meridianM);
        const double parallelM = normalM * std::cos(foundation::radiansOf(latitudeDeg));
        return onTile(tile, latitudeDeg, origin.longitudeDeg + foundation::degreesOf(east / parallelM),
                      heightM);
    };
}

/// `heights`: those of the file count from the zero of the header's offset; those above the ground do not.
PlanMap::Place placeByReference(const PlacedTile& tile, const GeoReference& reference, RoadHeights heights)
{
    return [&, heights](const glm::dvec2& plan, double heightM) -> foundation::Result<glm::dvec3>
    {
        const auto geodetic = reference.toGeodetic(glm::dvec3(plan, 0.0));
        if (!geodetic) return geodetic.error();
        const double zeroM = heights == RoadHeights::file ? geodetic->heightM : 0.0;
        return onTile(tile, geodetic->latitudeDeg, geodetic->longitudeDeg, zeroM + heightM);
    };
}

foundation::Result<PlanMap> mapOf(const RoadsRequest& request, const RoadNetwork& network,
                                  const PlacedTile& tile, const PlanExtent& extent)
{
    if (tile.frame().placement() == Placement::planar)
        return PlanMap::create(extent.low, extent.high,
                               [](const glm::dvec2& plan, double heightM) -> foundation::Result<glm::dvec3>
                               { return glm::dvec3(plan, heightM); });
    if (request.origin) return PlanMap::create(extent.low, extent.high, placeByOrigin(tile, *request.origin));
    const auto reference = GeoReference::create(network.header, request.file.string());
    if (!reference)
        return foundation::Error{reference.error().place, reference.error().what,
                                 "state where its (0, 0) lies: roads_origin = LAT LON [HEADING]"};
    return PlanMap::create(extent.low, extent.high, placeByReference(tile, *reference, request.heights));
}

/// The tile's ground below a place of the plan.
foundation::HeightInPlan groundUnder(const PlanMap& map, const PlacedTile& tile)
{
    return [&](const glm::dvec2& plan) -> std::optional<double>
    {
        double heightM = 0.0;
        for (int i = 0; i < 2; ++i) // the first height only straightens the way up
        {
            const glm::dvec3 place = map.toScene(glm::dvec3(plan, heightM));
            const auto ground = osgTerrainROAM::core::groundAt(tile, place.x, place.y);
            if (!ground) return std::nullopt;
            heightM = tile.frame().heightOf(ground->position);
        }
        return heightM;
    };
}

} // namespace

PlanExtent extentOf(const RoadNetwork& network)
{
    PlanExtent extent{glm::dvec2(1e300), glm::dvec2(-1e300)};
    for (const Road& road : network.roads)
        for (int i = 0, last = static_cast<int>(std::ceil(road.length / kExtentStepM));
             road.isUsable && i <= last; ++i)
        {
            const double s = std::min(i * kExtentStepM, road.length);
            const auto lanes = osgRoads::core::extentAt(road, s);
            const glm::dvec2 place = road.referenceLine.at(s).position;
            const glm::dvec2 reach(std::max(std::abs(lanes.leftT), std::abs(lanes.rightT)) + kExtentStepM);
            extent.low = glm::min(extent.low, place - reach);
            extent.high = glm::max(extent.high, place + reach);
        }
    return extent;
}

foundation::Result<RoadsFile> readRoads(const std::filesystem::path& file)
{
    auto read = osgRoads::core::readNetwork(file);
    if (!read) return read.error();
    RoadsFile roads{std::make_shared<const RoadNetwork>(std::move(read->network)),
                    osgRoads::core::firstMessages(read->problems, file.string())};
    for (std::string& note : TornRoads(*roads.network).notes(*roads.network, file.string()))
        roads.notes.push_back(std::move(note));
    return roads;
}

foundation::Result<SceneRoads> placeRoads(const RoadsRequest& request, const PlacedTile& tile)
{
    auto read = readRoads(request.file);
    return read ? placeRoads(request, std::move(*read), tile) : read.error();
}

foundation::Result<SceneRoads> placeRoads(const RoadsRequest& request, RoadsFile roads,
                                          const PlacedTile& tile)
{
    const auto& network = roads.network;
    const PlanExtent extent = extentOf(*network);
    auto map = mapOf(request, *network, tile, extent);
    if (!map) return map.error();
    std::shared_ptr<const GroundProfiles> base;
    if (request.heights == RoadHeights::ground)
        base = std::make_shared<GroundProfiles>(
            network, BaseSurface(extent.low, extent.high, groundUnder(*map, tile)));
    const auto datum = std::make_shared<SceneDatum>(std::move(*map), std::move(base));
    return SceneRoads{std::make_shared<osgRoads::core::PlacedNetwork>(network, datum), std::move(roads.notes),
                      request.file.string()};
}

} // namespace scenery
