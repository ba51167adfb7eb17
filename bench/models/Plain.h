// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Geode>
#include <osgSky/Atmosphere>

#include "scenery/nodes/ModelMesh.h"
#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/Sky.h"

/// Puts objects on a green plane with sky and atmosphere.
inline osg::ref_ptr<osg::Group> onPlain(osg::Node& objects, osgSky::Atmosphere& air)
{
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->setStateSet(air.stateSet());
    root->addChild(scenery::makeSky());
    scenery::ModelMesh slab;
    slab.addBox({-3e4F, -3e4F, -1.0F}, {3e4F, 3e4F, 0.0F}, {0.42F, 0.46F, 0.30F, 1.0F});
    const osg::ref_ptr<osg::Geode> ground = new osg::Geode;
    ground->addDrawable(slab.geometry());
    scenery::setObjectShading(*ground, scenery::Finish::matt);
    root->addChild(ground);
    root->addChild(&objects);
    return root;
}
