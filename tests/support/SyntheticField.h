// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "Random.h"

namespace testsupport
{

/// Rolling hills with rough ground on top; no two samples alike. Heights are multiples of 1/64 m, so that
/// they do not depend on a library's last bit.
inline osgTerrainROAM::core::HeightField hills(int columns, int rows, double spacingM = 30.0,
                                               std::uint64_t seed = 1)
{
    osgTerrainROAM::core::HeightField field;
    field.name = "hills";
    field.columns = columns;
    field.rows = rows;
    field.spacingEastM = field.spacingNorthM = spacingM;
    Random random(seed);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
        {
            const double x = column * 0.11, y = row * 0.07;
            const double height = 400.0 + 250.0 * std::sin(x) * std::cos(y) +
                                  90.0 * std::sin(0.31 * x + 2.3 * y) + 12.0 * random.unit();
            field.heightsM.push_back(static_cast<float>(std::floor(height * 64.0) / 64.0));
        }
    return field;
}

/// Puts a field on the Earth: 3 seconds of arc a sample, in the Alps, geoid 50 m above the ellipsoid.
inline osgTerrainROAM::core::HeightField onTheEarth(osgTerrainROAM::core::HeightField field)
{
    osgTerrainROAM::core::GeodeticNet net;
    net.step = 4;
    net.nodesPerSide = (field.tileSide() - 1) / net.step + 1;
    for (int b = 0; b < net.nodesPerSide; ++b)
        for (int a = 0; a < net.nodesPerSide; ++a)
            net.nodes.push_back({46.0 + b * net.step / 1200.0, 8.0 + a * net.step / 1200.0, 50.0});
    field.net = net;
    return field;
}

inline std::shared_ptr<const osgTerrainROAM::core::RoamTile>
planarTile(osgTerrainROAM::core::HeightField field,
           osgTerrainROAM::core::Storage storage = osgTerrainROAM::core::Storage::compact)
{
    using namespace osgTerrainROAM::core;
    return std::make_shared<const RoamTile>(PlacedTile(std::move(field), Placement::planar, storage));
}

} // namespace testsupport
