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

/// Computes how far a texel lies below (positive) or above its surroundings, over distances of 2, 4, … 64
/// texels, as a slope: the sum over the scales, weighted 1/√scale. Valleys are positive, ridges negative.
MapField hollowness(const MapField& heights, const MapGrid& grid, double spacingM);

/// Estimates the visible share of the sky, 0…1, from the hollowness: soft occlusion that shows relief,
/// without rays.
float skyVisibility(float hollow);

} // namespace osgTerrainROAM
