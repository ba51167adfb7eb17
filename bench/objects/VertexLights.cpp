// SPDX-License-Identifier: Apache-2.0
#include "VertexLights.h"

#include <cmath>
#include <numbers>
#include <string>

#include <osg/Program>
#include <osg/Uniform>

namespace objectbench
{

namespace
{

constexpr const char* kVertexShader = R"(
uniform vec4 lamps[LAMPS];
varying vec3 colour;
void main()
{
    vec3 place = gl_Vertex.xyz;
    vec3 normal = normalize(gl_Normal);
    vec3 toEye = normalize(gl_ModelViewMatrixInverse[3].xyz - place);
    vec3 sum = vec3(0.05);
    for (int i = 0; i < LAMPS; ++i)
    {
        vec3 toLamp = normalize(lamps[i].xyz - place);
        float shine = max(dot(normal, normalize(toLamp + toEye)), 0.0);
        vec3 tint = vec3(0.6 + 0.4 * lamps[i].w, 0.8, 1.0 - 0.4 * lamps[i].w);
        sum += tint * (max(dot(normal, toLamp), 0.0) + 0.3 * pow(shine, 16.0));
    }
    colour = sum * (2.0 / float(LAMPS));
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)";

constexpr const char* kFragmentShader = R"(#version 120
varying vec3 colour;
void main() { gl_FragColor = vec4(colour, 1.0); }
)";

} // namespace

osg::ref_ptr<osg::StateSet> vertexLights(int lights, const osg::BoundingSphere& ball)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    const osg::ref_ptr<osg::Uniform> lamps = new osg::Uniform(osg::Uniform::FLOAT_VEC4, "lamps", lights);
    for (int i = 0; i < lights; ++i)
    {
        // Evenly over a ball: equal steps in height, the golden angle around.
        const double height = 1.0 - (2.0 * i + 1.0) / lights;
        const double turn = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double across = std::sqrt(1.0 - height * height);
        const osg::Vec3d place =
            osg::Vec3d(ball.center()) +
            osg::Vec3d(across * std::cos(turn), across * std::sin(turn), height) * (3.0 * ball.radius());
        lamps->setElement(static_cast<unsigned>(i),
                          osg::Vec4(osg::Vec3(place), static_cast<float>(i) / static_cast<float>(lights)));
    }
    state->addUniform(lamps);
    const std::string head = "#version 120\n#define LAMPS " + std::to_string(lights) + "\n";
    const osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX, head + kVertexShader));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, kFragmentShader));
    state->setAttributeAndModes(program, osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE);
    return state;
}

} // namespace objectbench
