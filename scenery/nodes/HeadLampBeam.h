// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/StateSet>
#include <osg/Uniform>

#include "scenery/models/entities/EntityModel.h"
#include "scenery/nodes/Pose.h"

namespace scenery
{

/// The light that the head lamps of one vehicle throw on ground, roads and objects before it: two lamps as
/// one beam between them. Programs that contain Atmosphere::glslFunctions() and ask headLight() show it;
/// dark, it costs nothing. Threads: the update phase.
class HeadLampBeam
{
public:
    /// `scene`: the state of all that is lit.
    explicit HeadLampBeam(osg::StateSet& scene);

    /// `lamps`: of the vehicle; one without head lamps lights nothing. Frame of `vehicle`: world.
    void show(const Pose& vehicle, const std::vector<models::EntityLamp>& lamps, bool isLit);

private:
    osg::ref_ptr<osg::StateSet> _scene;
    osg::ref_ptr<osg::Uniform> _at, _axes;
};

} // namespace scenery
