// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include <osgTerrainROAM/ImageryLayer>

namespace osgTerrainROAM
{

/// Makes imagery that covers the ground of filled voids (HeightField::measured) with stripes of one colour,
/// and nothing else. It lies over all other imagery. Null image: the tile has no such ground.
ImageryLayer voidImagery(const core::PlacedTile& tile);

} // namespace osgTerrainROAM
