// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Image>
#include <osg/Vec2f>

#include "TileGround.h"

namespace osgTerrainROAM
{

/// The maps of the full-resolution surface for shading, which therefore does not change with the triangles.
struct SurfaceMap
{
    osg::ref_ptr<osg::Image> image; ///< 16 bits each: x, y, z of the unit normal (-1…1), height (0…1)
    osg::Vec4f fromGrid;            ///< texture coordinates = grid · xy + zw
    osg::Vec2f heights;             ///< layer's height = x + y · alpha
};

SurfaceMap surfaceMap(const TileGround& ground);

/// Makes the map of voids, one texel a cell: 0 where a corner is void and the cell is left out, 5 where it is
/// whole, 1…4 where only the south-west, south-east, north-west or north-east corner is missing: half of the
/// cell is drawn. Null: no sample is void.
osg::ref_ptr<osg::Image> holeMap(const ElevationSamples& samples);

} // namespace osgTerrainROAM
