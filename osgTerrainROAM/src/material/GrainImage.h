// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Image>

namespace osgTerrainROAM
{

/// Makes the detail texture, which is periodic and covers the ground at several scales at once
/// (shaders/Grain.glsl): red, green: slope of a bumpy surface (½: level); blue: fine speckle; alpha: broad
/// patches. All channels have mean ½, so that coarse mip levels change nothing. 512×512, 8 bits.
osg::ref_ptr<osg::Image> grainImage();

} // namespace osgTerrainROAM
