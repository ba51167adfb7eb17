// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/OcclusionProgram.h"

#include <string>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osgSky/Atmosphere>

#include <shaders/scenery.h>

namespace scenery
{

osg::ref_ptr<osg::Program> makeOcclusionProgram(const char* name, const char* fragmentMain)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName(name);
    const std::string version = "#version 130\n";
    program->addShader(new osg::Shader(osg::Shader::VERTEX, version + shaders::kShadowVertexMain));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, version + osgSky::Atmosphere::glslFunctions() +
                                                                  shaders::kOcclusion + fragmentMain));
    return program;
}

osg::ref_ptr<osg::StateSet> makeOcclusionState(osg::Program* program, int bin)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(program);
    state->setAttributeAndModes(new osg::BlendFunc(GL_ZERO, GL_SRC_COLOR));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    state->setRenderBinDetails(bin, "RenderBin");
    return state;
}

} // namespace scenery
