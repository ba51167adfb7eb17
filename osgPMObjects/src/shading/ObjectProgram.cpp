// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <osg/Image>
#include <osg/Uniform>

#include <osgPMObjects/ObjectShader>
#include <shaders/osgPMObjects.h>

namespace osgPMObjects
{

const char* glslVertexFunctions()
{
    return shaders::kObjectVertexFunctions;
}

const char* glslFragmentFunctions()
{
    return shaders::kObjectFragmentFunctions;
}

osg::ref_ptr<osg::Texture2D> whiteTexture()
{
    const osg::ref_ptr<osg::Image> pixel = new osg::Image;
    pixel->allocateImage(1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (int i = 0; i < 4; ++i)
        pixel->data()[i] = 255;
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(pixel);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    return texture;
}

void bindObjectAttributes(osg::Program& program)
{
    program.addBindAttribLocation("pmShown", kShownAttribute);
    program.addBindAttribLocation("pmPlace", kPlaceAttribute);
    program.addBindAttribLocation("pmTurn", kTurnAttribute);
    program.addBindAttribLocation("pmTargetPosition", kTargetPositionAttribute);
    program.addBindAttribLocation("pmTargetNormal", kTargetNormalAttribute);
    program.addBindAttribLocation("pmTargetColour", kTargetColourAttribute);
    program.addBindAttribLocation("pmTargetTexCoords", kTargetTexCoordsAttribute);
    program.addBindAttribLocation("pmLeafOffset", kLeafOffsetAttribute);
    program.addBindAttribLocation("pmLeafScale", kLeafScaleAttribute);
}

osg::ref_ptr<osg::Program> makeObjectProgram()
{
    const std::string version = "#version 130\n";
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("osgPMObjects");
    program->addShader(
        new osg::Shader(osg::Shader::VERTEX, version + glslVertexFunctions() + shaders::kObjectVertexMain));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT,
                                       version + glslFragmentFunctions() + shaders::kObjectFragmentMain));
    bindObjectAttributes(*program);
    return program;
}

void addObjectShading(osg::StateSet& state)
{
    state.setAttributeAndModes(makeObjectProgram());
    state.addUniform(new osg::Uniform("pmTexture", 0));
    if (!state.getTextureAttribute(0, osg::StateAttribute::TEXTURE))
        state.setTextureAttributeAndModes(0, whiteTexture());
}

} // namespace osgPMObjects
