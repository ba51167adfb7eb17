// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "MapGrid.h"

namespace osgTerrainROAM
{

/// A value per texel of the surface maps.
using MapField = std::vector<float>;

/// Heights of the map's texels, metres.
MapField mapHeights(const core::PlacedTile& tile, const MapGrid& grid);

/// How far a texel lies below (positive) or above its surroundings, over distances of 2, 4, … 64 texels, as a slope:
/// the sum over the scales, weighted 1/√scale. Valleys are positive, ridges negative.
MapField hollowness(const MapField& heights, const MapGrid& grid, double spacingM);

/// Share of the sky that a place sees, 0…1, guessed from its hollowness: soft occlusion that shows relief, without a
/// ray cast.
float skyVisibility(float hollow);

} // namespace osgTerrainROAM
