// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Image>

#include <osgTerrainROAM/Climate>

#include "MapGrid.h"

namespace osgTerrainROAM
{

/// Makes the map of vegetation, snow and water at the resolution of the data; the shader adds finer noise.
/// Red: vegetation (0 rock, 0.25 scree and soil, 0.5 grass, 0.75 meadow and shrub, 1 forest); green: snow (½:
/// half covered); blue: water (WaterMask.h); alpha: visible share of the sky. 8 bits each. The rule takes
/// height against the tree and snow lines, slope, hollows (wet, sheltered), the slope's side to the sun, and
/// noise.
/// Cost: about 0.5 µs a texel and core.
/// `normals`: normalMap() of the tile.
osg::ref_ptr<osg::Image> landMap(const core::PlacedTile& tile, const MapGrid& grid, const Climate& climate,
                                 const osg::Image& normals);

} // namespace osgTerrainROAM
