// SPDX-License-Identifier: Apache-2.0
#include "worldtool/EarthGround.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

namespace worldtool
{

namespace
{

using osgTerrainROAM::core::PlacedTile;

constexpr double kEdgeM = 5.0; ///< what stands nearer to the data's edge may lean beyond it

/// The width of the edge in steps of the grid.
glm::dvec2 edgeOf(const PlacedTile& tile)
{
    const auto stepM = [&](int column, int row)
    { return glm::distance(tile.frame().positionOf(0, 0, 0.0), tile.frame().positionOf(column, row, 0.0)); };
    return {kEdgeM / stepM(1, 0), kEdgeM / stepM(0, 1)};
}

/// Nothing within `edge` of the border of the data.
std::optional<double> heightOf(const PlacedTile& tile, const glm::dvec2& edge, double latitudeDeg,
                               double longitudeDeg)
{
    const auto& frame = tile.frame();
    const glm::dvec2 grid = frame.gridAt(frame.localFromGeodetic({latitudeDeg, longitudeDeg, 0.0}));
    const glm::dvec2 last(tile.grid().dataColumns() - 1, tile.grid().dataRows() - 1);
    if (!glm::all(glm::greaterThanEqual(grid, edge)) || !glm::all(glm::lessThanEqual(grid, last - edge)))
        return std::nullopt;
    double heightM = 0.0;
    for (int i = 0; i < 2; ++i) // the first height only straightens the way up
    {
        const glm::dvec3 place = frame.positionAt(grid.x, grid.y, heightM);
        const auto ground = osgTerrainROAM::core::groundAt(tile, place.x, place.y);
        if (!ground) return std::nullopt;
        heightM = frame.heightOf(ground->position);
    }
    return heightM;
}

worldmaking::MapBounds boundsOf(const PlacedTile& tile)
{
    const auto corner = [&](int column, int row)
    { return tile.frame().geodeticFromLocal(tile.frame().positionOf(column, row, 0.0)); };
    const int last = tile.grid().dataColumns() - 1, top = tile.grid().dataRows() - 1;
    const auto a = corner(0, 0), b = corner(last, 0), c = corner(last, top), d = corner(0, top);
    const auto [west, east] = std::minmax({a.longitudeDeg, b.longitudeDeg, c.longitudeDeg, d.longitudeDeg});
    const auto [south, north] = std::minmax({a.latitudeDeg, b.latitudeDeg, c.latitudeDeg, d.latitudeDeg});
    return {west, south, east, north};
}

} // namespace

foundation::Result<EarthGround> loadGround(const std::vector<std::filesystem::path>& dems)
{
    osgTerrainROAM::core::RoamFile description;
    description.dems = dems;
    auto loaded = osgTerrainROAM::core::loadTile(description);
    if (!loaded) return loaded.error();
    const auto tile = std::make_shared<const PlacedTile>(std::move(*loaded));
    if (tile->frame().placement() == osgTerrainROAM::core::Placement::planar)
        return foundation::Error{dems.front().string(), "has no georeference, so no map fits it",
                                 "give elevation data with a coordinate reference system"};
    const glm::dvec2 edge = edgeOf(*tile);
    return EarthGround{
        [tile, edge](double latitudeDeg, double longitudeDeg)
        { return heightOf(*tile, edge, latitudeDeg, longitudeDeg); },
        boundsOf(*tile), tile,
        [tile](const glm::dvec2& degrees)
        {
            const double heightM = heightOf(*tile, glm::dvec2(-0.01), degrees.y, degrees.x).value_or(0.0);
            const auto& frame = tile->frame();
            const glm::dvec2 grid = frame.gridAt(frame.localFromGeodetic({degrees.y, degrees.x, 0.0}));
            return frame.positionAt(grid.x, grid.y, heightM);
        }};
}

} // namespace worldtool
