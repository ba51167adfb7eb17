// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Texture2D>

namespace osgRoads
{

/// Makes the texture of a surface's grain, which repeats: red is noise of one texel (stones), green of 16
/// texels, blue of 64 texels (patches). All have the mean 0.5. Deterministic.
osg::ref_ptr<osg::Texture2D> makeGrainTexture();

} // namespace osgRoads
