// SPDX-License-Identifier: Apache-2.0
#include "Look.h"

#include <string>

#include <osgTerrainROAM/Atmosphere>

namespace framebench
{

using osgTerrainROAM::TerrainMaterial;

namespace
{

const char* const kReliefMain = R"(
in vec3 fromEye;
in vec2 grid;
uniform sampler2D terrainNormals;
uniform vec4 terrainMapFromGrid;
uniform mat3 terrainWorldFromLocal;

void main()
{
    float distanceM = length(fromEye);
    vec3 directionWorld = terrainWorldFromLocal * (fromEye / distanceM);
    vec2 tilt = texture(terrainNormals, grid * terrainMapFromGrid.xy + terrainMapFromGrid.zw).rg * 2.0 - 1.0;
    vec3 normalWorld = terrainWorldFromLocal * normalize(vec3(tilt, sqrt(max(1.0 - dot(tilt, tilt), 0.02))));
    vec3 light = sunLight() * max(dot(normalWorld, sunDirection()), 0.0) + ambientLight(normalWorld);
    gl_FragColor = vec4(displayColour(applyHaze(0.18 * light, directionWorld, distanceM)), 1.0);
}
)";

// 16 bits of the logarithm of the distance, and blue where there is ground at all.
const char* const kDistanceMain = R"(
in vec3 fromEye;
in vec2 grid;

void main()
{
    float v = clamp((log2(length(fromEye)) + 2.0) / 22.0, 0.0, 1.0) * 255.0;
    gl_FragColor = vec4(floor(v) / 255.0, fract(v), 1.0, 1.0);
}
)";

const char* const kPlainVertex = R"(#version 330 compatibility
uniform vec3 benchEye;
uniform vec2 benchSpacing;
out vec3 fromEye;
out vec2 grid;

void main()
{
    fromEye = gl_Vertex.xyz - gl_ModelViewMatrixInverse[3].xyz;
    grid = (fromEye.xy + benchEye.xy) / benchSpacing;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
    gl_ClipDistance[0] = 1.0;
    gl_ClipDistance[1] = 1.0;
}
)";

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
                               ? head + osgTerrainROAM::Atmosphere::glslFunctions() + kReliefMain
                               : head + kDistanceMain);
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
    return programOf(new osg::Shader(osg::Shader::VERTEX, kPlainVertex), fragmentShader(material, look));
}

} // namespace framebench
