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

constexpr double kMetresPerDegree = 111320.0, kSmallestKm = 1.0;
constexpr double kFinestM = 12.0;
constexpr int kMostPoints = 1000; ///< of the grid, a side

/// How much of a part of the ground people would settle on: samples on land that is no steeper than kGentle.
int gentleSamples(const MapBounds& part, const foundation::HeightOnEarth& ground)
{
    constexpr int kSamples = 16;
    constexpr double kGentle = 0.06, kStepDeg = 0.002;
    int gentle = 0;
    for (int row = 0; row < kSamples; ++row)
        for (int column = 0; column < kSamples; ++column)
        {
            const double north = part.south + (part.north - part.south) * (row + 0.5) / kSamples,
                         east = part.west + (part.east - part.west) * (column + 0.5) / kSamples;
            const auto here = ground(north, east), beside = ground(north + kStepDeg, east);
            if (here && beside && *here > 0.5 &&
                std::abs(*beside - *here) < kGentle * kStepDeg * kMetresPerDegree)
                ++gentle;
        }
    return gentle;
}

/// The part of the size that is filled: that with the most gentle land, the middle one of equals.
MapBounds cutToSize(const MapBounds& bounds, const foundation::HeightOnEarth& ground)
{
    const double latitude = 0.5 * (bounds.south + bounds.north);
    const double perEast = kMetresPerDegree * std::cos(latitude * std::numbers::pi / 180.0);
    const double width = std::min(bounds.east - bounds.west, 1000.0 * kLargestKm / perEast),
                 height = std::min(bounds.north - bounds.south, 1000.0 * kLargestKm / kMetresPerDegree);
    const double freeEast = bounds.east - bounds.west - width,
                 freeNorth = bounds.north - bounds.south - height;
    MapBounds best;
    double most = -1.0;
    for (int row = 0; row <= 4; ++row)
        for (int column = 0; column <= 4; ++column)
        {
            const double west = bounds.west + 0.25 * column * freeEast,
                         south = bounds.south + 0.25 * row * freeNorth;
            const MapBounds part{west, south, west + width, south + height};
            const double score =
                gentleSamples(part, ground) - 0.01 * (std::abs(row - 2) + std::abs(column - 2));
            if (score > most) most = score, best = part;
        }
    return best;
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

/// Heights in the plane about bounds, for one thread: planes are asked by one at a time.
foundation::HeightInPlan planHeights(const MapBounds& bounds, const foundation::HeightOnEarth& ground)
{
    auto plane = planeAbout(bounds);
    if (!plane) return [](const glm::dvec2&) { return std::optional<double>(); };
    return [own = std::move(*plane), &ground](const glm::dvec2& plan) -> std::optional<double>
    {
        const auto place = own.toDegrees(plan);
        return place ? ground(place->y, place->x) : std::nullopt;
    };
}

/// The box of the plane around bounds.
std::optional<MapBox> boxAround(const MapBounds& bounds, const MapPlane& plane)
{
    const auto southWest = plane.toPlan({bounds.west, bounds.south}),
               southEast = plane.toPlan({bounds.east, bounds.south}),
               northWest = plane.toPlan({bounds.west, bounds.north}),
               northEast = plane.toPlan({bounds.east, bounds.north});
    if (!southWest || !southEast || !northWest || !northEast) return std::nullopt;
    return MapBox{{std::min(southWest->x, northWest->x), std::min(southWest->y, southEast->y)},
                  {std::max(southEast->x, northEast->x), std::max(northWest->y, northEast->y)}};
}

} // namespace

foundation::Result<MadeUpMap> makeUpMap(const foundation::HeightOnEarth& ground,
                                        const MadeUpSettings& settings)
{
    const MapBounds bounds = cutToSize(settings.bounds, ground);
    const auto plane = planeAbout(bounds);
    if (!plane) return plane.error();
    const auto box = boxAround(bounds, *plane);
    if (!box || std::min(box->high.x - box->low.x, box->high.y - box->low.y) < 1000.0 * kSmallestKm)
        return Error{"the made-up map", "the ground is less than 1 km wide",
                     "give --map, or larger elevation data"};
    const double widthM = std::max(box->high.x - box->low.x, box->high.y - box->low.y);
    const GroundGrid grid(*box, std::max(kFinestM, widthM / kMostPoints),
                          GroundGrid::HeightMaker([&] { return planHeights(bounds, ground); }));
    MadeUpLand land(grid, settings);
    land.make();
    if (land.report.roadsKm <= 0.0)
        return Error{"the made-up map",
                     "the ground is too small, or nowhere gentle enough, for a settlement and its roads",
                     "give --map, or larger or gentler elevation data"};
    MadeUpMap made;
    made.report = land.report;
    made.hasSea = grid.hasSea();
    made.treeLineM = land.treeLineM();
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
