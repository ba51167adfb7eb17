// SPDX-License-Identifier: Apache-2.0
#include "worldtool/EarthGround.h"

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

std::optional<double> heightOf(const PlacedTile& tile, double latitudeDeg, double longitudeDeg)
{
    const auto& frame = tile.frame();
    const glm::dvec2 grid = frame.gridAt(frame.localFromGeodetic({latitudeDeg, longitudeDeg, 0.0}));
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

} // namespace

foundation::Result<worldmaking::GroundOnEarth> loadGround(const std::vector<std::filesystem::path>& dems)
{
    osgTerrainROAM::core::RoamFile description;
    description.dems = dems;
    auto loaded = osgTerrainROAM::core::loadTile(description);
    if (!loaded) return loaded.error();
    const auto tile = std::make_shared<const PlacedTile>(std::move(*loaded));
    if (tile->frame().placement() == osgTerrainROAM::core::Placement::planar)
        return foundation::Error{dems.front().string(), "has no georeference, so no map fits it",
                                 "give elevation data with a coordinate reference system"};
    return worldmaking::GroundOnEarth([tile](double latitudeDeg, double longitudeDeg)
                                      { return heightOf(*tile, latitudeDeg, longitudeDeg); });
}

} // namespace worldtool
