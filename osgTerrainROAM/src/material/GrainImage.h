// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Image>

namespace osgTerrainROAM
{

/// The one detail texture, tileable, laid over the ground at several scales at once:
/// red, green: slope of a bumpy surface (½: level); blue: fine speckle; alpha: broad patches.
/// All channels have mean ½, so that a small mip level changes nothing. 512×512, 8 bits.
osg::ref_ptr<osg::Image> grainImage();

} // namespace osgTerrainROAM
