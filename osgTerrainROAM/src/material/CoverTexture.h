// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Image>

#include <osgTerrainROAM/core/cover/CoverImport.h>

namespace osgTerrainROAM
{

/// Land cover as an image of one byte a texel, the number of its kind, with mip levels: each texel is what most of the (up
/// to) four below it are, the first of them in doubt. A mean of numbers of kinds would be some other kind.
osg::ref_ptr<osg::Image> coverImage(const core::CoverMap& map);

} // namespace osgTerrainROAM
