// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/ContentMark.h>

#include <osgTerrainROAM/core/RoamFile.h>

namespace osgTerrainROAM::core
{

/// The climate of a tile: it decides where trees end, where snow lies and how green the land is.
/// Units: metres as the samples are counted (above the sea in nearly all elevation files).
struct Climate
{
    double aridity = 0.15; ///< 0 wet and green … 1 desert
    double treeLineM = 2000.0;
    double snowLineM = 2700.0; ///< of early summer
    double seaLevelM = 0.0;
    WaterRule water = WaterRule::level;
    double latitudeDeg = 47.0; ///< how much the seasons change, and when
};

/// Estimates the climate of a position on the Earth by a rule of thumb, for looks only:
/// - tree line, between fixed points over latitude: 0° 3700 m, 30° 3900 m, 47° 2050 m, 60° 1050 m, 70° 350 m,
///   80° 0;
/// - snow line (early summer, some 600 m below that of late summer): 0° 4700 m, 30° 4800 m, 36° 3250 m, 47°
///   2550 m, 60° 1300 m, 70° 600 m, 85° 0; both a quarter lower south of 40° S, where the oceans keep summers
///   cool;
/// - aridity: 0.12, raised within ellipses around the world's dry lands (Sahara and Arabia, Iran and
///   Turkestan, Gobi, Thar, western North America's basins, Atacama and the dry Andes, eastern Patagonia,
///   Kalahari and Namib, inner Australia); drier air lifts the snow line by up to 700 m.
/// Units: degrees. The result depends on the arguments alone.
Climate climateAt(double latitudeDeg, double longitudeDeg);

/// Estimates the climate of the tile's centre (47° N, humid, for a tile without a position on the Earth);
/// values in `land` replace the estimate.
Climate climateOf(const PlacedTile& tile, const LandParameters& land);

/// The mark of all values of a climate.
foundation::ContentMark markOfClimate(const Climate& climate);

} // namespace osgTerrainROAM::core
