// SPDX-License-Identifier: Apache-2.0
#include "scenery/ground/TileGround.h"

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
    glm::dvec2 low(0.0), high(0.0); // means
    const int lastColumn = tile.grid().dataColumns() - 1, lastRow = tile.grid().dataRows() - 1;
    for (int row = 0; row <= lastRow; ++row)
    {
        terrain.westM = std::max(terrain.westM, tile.position(0, row).x);
        terrain.eastM = std::min(terrain.eastM, tile.position(lastColumn, row).x);
        low.x += tile.position(0, row).x / (lastRow + 1);
        high.x += tile.position(lastColumn, row).x / (lastRow + 1);
    }
    for (int column = 0; column <= lastColumn; ++column)
    {
        terrain.southM = std::max(terrain.southM, tile.position(column, 0).y);
        terrain.northM = std::min(terrain.northM, tile.position(column, lastRow).y);
        low.y += tile.position(column, 0).y / (lastColumn + 1);
        high.y += tile.position(column, lastRow).y / (lastColumn + 1);
    }
    if (terrain.westM >= terrain.eastM || terrain.southM >= terrain.northM)
    {
        terrain.westM = low.x;
        terrain.southM = low.y;
        terrain.eastM = high.x;
        terrain.northM = high.y;
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
    if (!tile.field().measured.hasAll())
        terrain.isMeasured = [&tile](double eastM, double northM)
        {
            const glm::ivec2 sample(
                glm::round(tile.frame().gridNear({eastM, northM}) / double(tile.grid().cellSide())));
            return tile.field().measured.holds(std::clamp(sample.x, 0, tile.field().columns - 1),
                                               std::clamp(sample.y, 0, tile.field().rows - 1));
        };
    return terrain;
}

} // namespace ground
