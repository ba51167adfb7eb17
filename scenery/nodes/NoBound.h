// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Drawable>

namespace scenery
{

/// Of a drawable without a place in the world: it has no share in the bounds of the scene, nor in near and
/// far planes.
struct NoBound : public osg::Drawable::ComputeBoundingBoxCallback
{
    osg::BoundingBox computeBound(const osg::Drawable&) const override { return {}; }
};

} // namespace scenery
