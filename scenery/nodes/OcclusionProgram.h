// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Program>
#include <osg/StateSet>

namespace scenery
{

/// The program of surfaces that darken the ground below them: shadows of what moves, and sky that things
/// hide. `fragmentMain` follows the functions of Atmosphere and Occlusion.glsl.
osg::ref_ptr<osg::Program> makeOcclusionProgram(const char* name, const char* fragmentMain);

/// Multiplies what is drawn before `bin`, and writes no depth.
osg::ref_ptr<osg::StateSet> makeOcclusionState(osg::Program* program, int bin);

} // namespace scenery
