// SPDX-License-Identifier: Apache-2.0
#include "VertexLights.h"

#include <cmath>
#include <numbers>
#include <string>

#include <osg/Program>
#include <osg/Uniform>

#include <shaders/objectbench.h>

namespace objectbench
{

osg::ref_ptr<osg::StateSet> vertexLights(int lights, const osg::BoundingSphere& ball)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    const osg::ref_ptr<osg::Uniform> lamps = new osg::Uniform(osg::Uniform::FLOAT_VEC4, "lamps", lights);
    for (int i = 0; i < lights; ++i)
    {
        // The lamps lie evenly around a ball: equal steps in height, the golden angle around.
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
    program->addShader(new osg::Shader(osg::Shader::VERTEX, head + shaders::kVertexLights));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, shaders::kVertexColourFrag));
    state->setAttributeAndModes(program, osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE);
    return state;
}

} // namespace objectbench
