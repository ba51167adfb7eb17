// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/MadeUpMap.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include <osgRoads/core/network/RoadNetwork.h>

#include "worldmaking/madeup/MadeUpLand.h"
#include "worldmaking/map/MapPlane.h"

namespace worldmaking
{

namespace
{

using foundation::Error;

constexpr double kMetresPerDegree = 111320.0, kSmallestKm = 3.0;
constexpr double kFinestM = 12.0;
constexpr int kMostPoints = 1000; ///< of the grid, a side

MapBounds cutToSize(const MapBounds& bounds)
{
    const double latitude = 0.5 * (bounds.south + bounds.north),
                 longitude = 0.5 * (bounds.west + bounds.east);
    const double perEast = kMetresPerDegree * std::cos(latitude * std::numbers::pi / 180.0);
    const double halfEast = std::min(0.5 * (bounds.east - bounds.west), 500.0 * kLargestKm / perEast),
                 halfNorth =
                     std::min(0.5 * (bounds.north - bounds.south), 500.0 * kLargestKm / kMetresPerDegree);
    return {longitude - halfEast, latitude - halfNorth, longitude + halfEast, latitude + halfNorth};
}

foundation::Result<MapPlane> planeAbout(const MapBounds& bounds)
{
    osgRoads::core::NetworkHeader header;
    char text[160];
    std::snprintf(text, sizeof text,
                  "+proj=tmerc +lat_0=%.6f +lon_0=%.6f +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
                  0.5 * (bounds.south + bounds.north), 0.5 * (bounds.west + bounds.east));
    header.geoReference = text;
    return MapPlane::create(header, "the made-up map");
}

/// The box of the plane that lies within bounds.
std::optional<MapBox> boxWithin(const MapBounds& bounds, const MapPlane& plane)
{
    const auto southWest = plane.toPlan({bounds.west, bounds.south}),
               southEast = plane.toPlan({bounds.east, bounds.south}),
               northWest = plane.toPlan({bounds.west, bounds.north}),
               northEast = plane.toPlan({bounds.east, bounds.north});
    if (!southWest || !southEast || !northWest || !northEast) return std::nullopt;
    return MapBox{{std::max(southWest->x, northWest->x), std::max(southWest->y, southEast->y)},
                  {std::min(southEast->x, northEast->x), std::min(northWest->y, northEast->y)}};
}

} // namespace

foundation::Result<MadeUpMap> makeUpMap(const GroundOnEarth& ground, const MadeUpSettings& settings)
{
    const MapBounds bounds = cutToSize(settings.bounds);
    const auto plane = planeAbout(bounds);
    if (!plane) return plane.error();
    const auto box = boxWithin(bounds, *plane);
    if (!box || std::min(box->high.x - box->low.x, box->high.y - box->low.y) < 1000.0 * kSmallestKm)
        return Error{"the made-up map", "the ground is less than 3 km wide",
                     "give --map, or larger elevation data"};
    const double widthM = std::max(box->high.x - box->low.x, box->high.y - box->low.y);
    const GroundGrid grid(*box, std::max(kFinestM, widthM / kMostPoints),
                          [&](const glm::dvec2& plan) -> std::optional<double>
                          {
                              const auto place = plane->toDegrees(plan);
                              return place ? ground(place->y, place->x) : std::nullopt;
                          });
    MadeUpLand land(grid, settings);
    land.make();
    MadeUpMap made;
    made.report = land.report;
    made.hasSea = grid.hasSea();
    std::int64_t id = 0;
    for (const MadeShape& shape : land.shapes)
    {
        auto degrees = plane->toDegrees(shape.paths);
        if (!degrees) continue;
        made.land.shapes.push_back({++id, shape.form, std::move(*degrees), shape.tags});
    }
    for (const auto& [kind, place] : land.places)
        if (const auto degrees = plane->toDegrees(place)) made.places.push_back({kind, *degrees});
    if (land.airfield)
    {
        const auto from = plane->toDegrees(land.airfield->from), to = plane->toDegrees(land.airfield->to);
        if (from && to)
            made.runways.push_back(
                {"MADE", land.airfield->designators(), *from, *to, Airfield::kWidthM, "asphalt"});
    }
    return made;
}

} // namespace worldmaking
