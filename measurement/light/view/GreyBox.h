// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Geode>

#include "scenery/nodes/ModelMesh.h"
#include "scenery/nodes/ObjectShading.h"

namespace measurement
{

/// A box with one reflectance, shaded as objects are. Metres.
inline osg::ref_ptr<osg::Node> greyBox(const osg::Vec3f& low, const osg::Vec3f& high, float grey,
                                       scenery::Finish finish = scenery::Finish::matt)
{
    scenery::ModelMesh mesh;
    mesh.addBox(low, high, {grey, grey, grey, 1.0F});
    const osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(mesh.geometry());
    scenery::setObjectShading(*node, finish);
    return node;
}

/// Level grey ground around the origin, to the horizon.
inline osg::ref_ptr<osg::Node> greyPlain()
{
    return greyBox({-1.5e5F, -1.5e5F, -1.0F}, {1.5e5F, 1.5e5F, 0.0F}, 0.5F);
}

} // namespace measurement
