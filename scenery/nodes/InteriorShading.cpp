// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/InteriorShading.h"

#include <string>

#include <osgSky/Atmosphere>

#include <osgPMObjects/ObjectShader>
#include <shaders/scenery.h>

namespace scenery
{

namespace
{

osg::ref_ptr<osg::Program> programOf(const char* name, const std::string& fragment)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName(name);
    const std::string version = "#version 130\n";
    program->addShader(new osg::Shader(osg::Shader::VERTEX, version + osgPMObjects::glslVertexFunctions() +
                                                                shaders::kObjectVertexMain));
    program->addShader(
        new osg::Shader(osg::Shader::FRAGMENT, version + osgPMObjects::glslFragmentFunctions() + fragment));
    osgPMObjects::bindObjectAttributes(*program);
    return program;
}

/// Shares of the sun and of the sky.
osg::Vec2f shareOf(models::InteriorCoat coat)
{
    switch (coat)
    {
    case models::InteriorCoat::dial:
        return {0.10F, 0.55F};
    case models::InteriorCoat::lamp:
        return {0.0F, 0.0F};
    default:
        return {0.22F, 0.42F};
    }
}

} // namespace

osg::ref_ptr<osg::Program> makeInteriorProgram()
{
    return programOf("interior", std::string(osgSky::Atmosphere::glslFunctions()) + shaders::kInteriorMain);
}

osg::ref_ptr<osg::Program> makeMirrorProgram()
{
    return programOf("mirror", shaders::kMirrorMain);
}

void setInteriorShading(osg::Node& node, models::InteriorCoat coat)
{
    if (coat == models::InteriorCoat::outside) return;
    static const osg::ref_ptr<osg::Program> kProgram = makeInteriorProgram();
    osg::StateSet& state = *node.getOrCreateStateSet();
    // The states of the model below name the program of objects.
    state.setAttributeAndModes(kProgram, osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    state.addUniform(new osg::Uniform("interiorShare", shareOf(coat)));
    const float lamp = coat == models::InteriorCoat::lamp ? 2.0F : 0.0F;
    state.addUniform(new osg::Uniform("interiorLamp", osg::Vec3f(lamp, lamp, lamp)));
}

} // namespace scenery
