// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Texture2D>

#include "scenery/models/Paint.h"

namespace scenery
{

/// Returns the texture of a painting, with its mipmaps; those of foliage keep their coverage with distance.
/// All who ask for the same have the same one, for as long as somebody uses it, so nobody may change it. What
/// was painted before is found among the user's kept results. `anisotropy`: of its filter, at most.
/// Threads: any number.
osg::ref_ptr<osg::Texture2D> paintedTexture(models::Painting painting, bool isFoliage, float anisotropy,
                                            const models::VehicleLook* look = nullptr);

} // namespace scenery
