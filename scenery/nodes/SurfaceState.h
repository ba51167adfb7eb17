// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/StateSet>
#include <osg/Texture2D>

#include "scenery/models/Model.h"

namespace scenery
{

/// Makes the state of a surface of a generated model, with the texture of its painting.
osg::ref_ptr<osg::StateSet> surfaceState(const models::Surface& surface, osg::Texture2D* texture);

} // namespace scenery
