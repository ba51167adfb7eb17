// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Image>

#include "MapGrid.h"

namespace osgTerrainROAM
{

/// Normals of the full-resolution surface, from central differences of placed positions: x and y of the unit
/// normal in the tile's frame as 16 bits each (-1…1 on 0…65535), so that shading neither depends on the level of
/// detail nor shows bands. z follows, for it is positive.
osg::ref_ptr<osg::Image> normalMap(const core::PlacedTile& tile, const MapGrid& grid);

/// x and y of the unit normal at a texel of a normalMap().
glm::dvec2 tiltAt(const osg::Image& normalMap, int x, int y);

} // namespace osgTerrainROAM
