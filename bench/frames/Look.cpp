// SPDX-License-Identifier: Apache-2.0
#include "Look.h"

#include <string>

#include <osgSky/Atmosphere>

#include <shaders/framebench.h>

namespace framebench
{

using osgTerrainROAM::TerrainMaterial;

namespace
{

osg::Shader* shaderOf(const TerrainMaterial& material, osg::Shader::Type type)
{
    auto* program =
        dynamic_cast<osg::Program*>(material.stateSet()->getAttribute(osg::StateAttribute::PROGRAM));
    for (unsigned int i = 0; program && i < program->getNumShaders(); ++i)
        if (program->getShader(i)->getType() == type) return program->getShader(i);
    return nullptr;
}

osg::ref_ptr<osg::Shader> fragmentShader(const TerrainMaterial& material, Look look)
{
    if (look == Look::full) return shaderOf(material, osg::Shader::FRAGMENT);
    const std::string head = "#version 330 compatibility\n";
    return new osg::Shader(osg::Shader::FRAGMENT,
                           look == Look::relief
                               ? head + osgSky::Atmosphere::glslFunctions() + shaders::kReliefMain
                               : head + shaders::kDistanceMain);
}

osg::ref_ptr<osg::Program> programOf(osg::Shader* vertex, osg::Shader* fragment)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(vertex);
    program->addShader(fragment);
    return program;
}

} // namespace

osg::ref_ptr<osg::StateSet> lookState(const TerrainMaterial& material, Look look)
{
    if (look == Look::full) return material.stateSet();
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet(*material.stateSet(), osg::CopyOp::SHALLOW_COPY);
    state->setAttributeAndModes(
        programOf(shaderOf(material, osg::Shader::VERTEX), fragmentShader(material, look)));
    return state;
}

osg::ref_ptr<osg::Program> plainVertexProgram(const TerrainMaterial& material, Look look)
{
    return programOf(new osg::Shader(osg::Shader::VERTEX, shaders::kPlainVerticesVert),
                     fragmentShader(material, look));
}

} // namespace framebench
