// SPDX-License-Identifier: Apache-2.0
#include "ground/TileGround.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

namespace ground
{

using osgTerrainROAM::core::PlacedTile;
using osgTerrainROAM::core::Placement;

std::optional<simulation::Geodetic> originOf(const PlacedTile& tile)
{
    if (tile.frame().placement() == Placement::planar) return std::nullopt;
    return simulation::Geodetic{tile.frame().origin().latitudeDeg, tile.frame().origin().longitudeDeg,
                                tile.frame().origin().heightM};
}

simulation::GroundProvider groundOf(const PlacedTile& tile)
{
    return [&tile](double eastM, double northM) -> std::optional<simulation::GroundSample>
    {
        const auto point = osgTerrainROAM::core::groundAt(tile, eastM, northM);
        if (!point) return std::nullopt;
        return simulation::GroundSample{point->position.z};
    };
}

simulation::TourTerrain tourTerrainOf(const PlacedTile& tile, const std::string& sceneFile)
{
    constexpr double kFar = std::numeric_limits<double>::max();
    simulation::TourTerrain terrain{-kFar, -kFar, kFar, kFar, {}, 0.0, originOf(tile), sceneFile};
    const int lastColumn = tile.grid().dataColumns() - 1, lastRow = tile.grid().dataRows() - 1;
    for (int row = 0; row <= lastRow; ++row)
    {
        terrain.westM = std::max(terrain.westM, tile.position(0, row).x);
        terrain.eastM = std::min(terrain.eastM, tile.position(lastColumn, row).x);
    }
    for (int column = 0; column <= lastColumn; ++column)
    {
        terrain.southM = std::max(terrain.southM, tile.position(column, 0).y);
        terrain.northM = std::min(terrain.northM, tile.position(column, lastRow).y);
    }
    terrain.sampleSpacingM = std::min(tile.field().spacingEastM, tile.field().spacingNorthM);
    terrain.heightM = [&tile](double eastM, double northM)
    {
        // The rectangle's rim may miss the data by a rounding error: its nearest sample stands in.
        if (const auto point = osgTerrainROAM::core::groundAt(tile, eastM, northM)) return point->position.z;
        const glm::dvec2 place = tile.frame().gridAt({eastM, northM, 0.0});
        const int column =
            std::clamp(static_cast<int>(std::lround(place.x)), 0, tile.grid().dataColumns() - 1);
        const int row = std::clamp(static_cast<int>(std::lround(place.y)), 0, tile.grid().dataRows() - 1);
        return tile.position(column, row).z;
    };
    return terrain;
}

} // namespace ground
