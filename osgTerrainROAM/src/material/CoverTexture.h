// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Image>

#include <osgTerrainROAM/core/cover/CoverImport.h>

namespace osgTerrainROAM
{

/// Makes the image of a land cover: one byte a texel, the number of its class, with mip levels. A texel of a
/// mip level has the class of most of the (up to) four texels below it, of the first in doubt: a mean of
/// class numbers would be another class.
osg::ref_ptr<osg::Image> coverImage(const core::CoverMap& map);

} // namespace osgTerrainROAM
