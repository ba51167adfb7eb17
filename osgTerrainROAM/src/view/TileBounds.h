// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/BoundingBox>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM
{

/// Computes a box around the placed data samples, in the tile's frame, from the lowest and highest sample of
/// each block of 16×16 cells at the block's corners. Metres. Cost: one visit of every sample.
osg::BoundingBox tileBounds(const core::PlacedTile& placed);

} // namespace osgTerrainROAM
