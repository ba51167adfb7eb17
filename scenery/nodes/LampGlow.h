// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <osg/Geometry>
#include <osg/Program>

#include "scenery/models/entities/EntityModel.h"

namespace scenery
{

/// The glow about lamps: squares that look at the eye and add light, so that far lamps are seen and near ones
/// dazzle by night. It shines within the angle of its lamp. Frame: the entity's. Threads: light() in the
/// update phase.
class LampGlow
{
public:
    explicit LampGlow(const std::vector<models::EntityLamp>& lamps);

    osg::Node* node() const { return _node.get(); }

    /// `lights`: of each lamp, linear; 0: it is dark.
    void light(const std::vector<osg::Vec3f>& lights);

private:
    std::vector<float> _edges; ///< cosines of half the angle of each lamp
    osg::ref_ptr<osg::Vec4Array> _colours = new osg::Vec4Array;
    osg::ref_ptr<osg::Node> _node;
};

/// The program of the glow: its light fades towards the edge and in the haze.
osg::ref_ptr<osg::Program> makeLampGlowProgram();

} // namespace scenery
