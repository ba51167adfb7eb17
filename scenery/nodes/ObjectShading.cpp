// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/ObjectShading.h"

#include <string>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Program>
#include <osgSky/Atmosphere>

#include <osgPMObjects/ObjectShader>
#include <shaders/scenery.h>

#include "scenery/models/paint/MipChain.h"

namespace scenery
{

namespace
{

/// What a white sheet shows at night with its lamp on; 1 is a white wall in the sun.
constexpr float kLampBehindSheet = 0.4F;

/// What the shader calls objectLeaves.
float leavesOf(Finish finish)
{
    return finish == Finish::foliage ? 1.0F : finish == Finish::blades ? 0.5F : 0.0F;
}

} // namespace

void setObjectShading(osg::Node& node, Finish finish)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("object");
    const std::string version = "#version 130\n";
    program->addShader(new osg::Shader(osg::Shader::VERTEX, version + osgPMObjects::glslVertexFunctions() +
                                                                shaders::kObjectVertexMain));
    program->addShader(new osg::Shader(
        osg::Shader::FRAGMENT, version + osgPMObjects::glslFragmentFunctions() +
                                   osgSky::Atmosphere::glslFunctions() + shaders::kObjectFragmentMain));
    osgPMObjects::bindObjectAttributes(*program);
    osg::StateSet* state = node.getOrCreateStateSet();
    state->setAttributeAndModes(program);
    state->addUniform(new osg::Uniform("objectTexture", 0));
    state->addUniform(new osg::Uniform("objectLacquer", finish == Finish::lacquered ? 1.0F : 0.0F));
    if (finish == Finish::lacquered) state->setDefine("OBJECT_LACQUER");
    state->addUniform(new osg::Uniform("objectLamp", finish == Finish::lit ? kLampBehindSheet : 0.0F));
    state->addUniform(new osg::Uniform("objectLeaves", leavesOf(finish)));
    state->addUniform(new osg::Uniform("objectCutOut", static_cast<float>(models::kAlphaThreshold) / 255.0F));
    state->addUniform(new osg::Uniform("objectTintMask", 0.0F));
    state->setTextureAttributeAndModes(0, osgPMObjects::whiteTexture());
    if (finish != Finish::seeThrough) return;
    state->setDefine("OBJECT_BARE");
    state->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
    state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
}

} // namespace scenery
