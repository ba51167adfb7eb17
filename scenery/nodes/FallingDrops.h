// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Geometry>
#include <osg/Node>
#include <osg/Program>
#include <osg/Uniform>
#include <osg/Vec3d>

#include "simulation/environment/Hydrometeors.h"

namespace scenery
{

/// Rain or snow around every eye: a box of 12 m full of streaks or flakes, that stands still in the world
/// while the eye goes through it, since what leaves it on one side comes in on the other. A streak is as long
/// as a drop's way relative to the eye in a fiftieth of a second. Farther off rain is seen as the haze that
/// it makes (simulation::visibilityM()). At most kMostDrops are drawn, all that have 2 mm in rain of up to 6
/// mm an hour; beyond, and in snow, those that are drawn are wider. Needs the uniforms of an Atmosphere above
/// it. It casts no shadow when it is beside what SunShadows lights, has no bound and is never culled. Frame:
/// world. Threads: show() in the update phase. The picture depends on the last show() alone.
/// Source: Garg and Nayar, *Vision and rain* (2007), section 2: drops are seen as streaks that take their
/// light from a wide part of the sky.
class FallingDrops
{
public:
    static constexpr int kMostDrops = 20000;
    static constexpr double kBoxM = 12.0; ///< side of the box

    FallingDrops();
    osg::Node& node() const { return *_node; }

    /// Shows what falls at a time. `wind` and `eye`: velocities of air and eye, m/s.
    void show(const simulation::Hydrometeors& falling, double timeS, const osg::Vec3d& wind,
              const osg::Vec3d& eye);

    /// The number of drops or flakes that are drawn around an eye.
    int shownDrops() const;

private:
    osg::ref_ptr<osg::Node> _node;
    osg::ref_ptr<osg::DrawArrays> _faces;
    osg::ref_ptr<osg::Uniform> _shift, _streak, _look;
};

/// The program of the drops, with the shaders of the atmosphere.
osg::ref_ptr<osg::Program> makeFallingDropsProgram();

} // namespace scenery
