// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/LampGlow.h"

#include <cmath>
#include <numbers>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geode>
#include <osg/Program>
#include <osgSky/Atmosphere>

#include <shaders/scenery.h>

#include "scenery/nodes/LampQuads.h"

namespace scenery
{

namespace
{

/// Half the width of the glow of a lamp: some times its lens.
float glowM(const models::EntityLamp& lamp)
{
    constexpr double kLeastM = 0.12, kLenses = 1.6;
    return static_cast<float>(std::max(kLeastM, kLenses * std::max(lamp.widthM, lamp.heightM)));
}

osg::Vec3f middleOfLight(const models::EntityLamp& lamp)
{
    const double ahead = lamp.looksAhead ? 1.0 : -1.0;
    return osg::Vec3f(osg::Vec3d(ahead * std::cos(lamp.asideRad), std::sin(lamp.asideRad), 0.0));
}

osg::ref_ptr<osg::StateSet> glowState()
{
    const osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(makeLampGlowProgram());
    state->setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    state->setRenderBinDetails(11, "DepthSortedBin"); // after what is blended
    return state;
}

/// The bound reaches as far as glow does at usual distances.
struct GlowBound : public osg::Drawable::ComputeBoundingBoxCallback
{
    osg::BoundingBox computeBound(const osg::Drawable& drawable) const override
    {
        constexpr float kReachM = 3.0F;
        osg::BoundingBox box = drawable.computeBoundingBox();
        box._min -= osg::Vec3f(kReachM, kReachM, kReachM);
        box._max += osg::Vec3f(kReachM, kReachM, kReachM);
        return box;
    }
};

} // namespace

osg::ref_ptr<osg::Program> makeLampGlowProgram()
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("lamp glow");
    const std::string version = "#version 130\n";
    program->addShader(new osg::Shader(osg::Shader::VERTEX, version + shaders::kGlowVertexMain));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT,
                                       version + osgSky::Atmosphere::glslFunctions() + shaders::kGlowMain));
    return program;
}

LampGlow::LampGlow(const std::vector<models::EntityLamp>& lamps)
{
    const osg::ref_ptr<osg::Vec3Array> across = new osg::Vec3Array;
    for (const models::EntityLamp& lamp : lamps)
    {
        _edges.push_back(
            lamp.halfAngleRad >= std::numbers::pi ? -1.0F : static_cast<float>(std::cos(lamp.halfAngleRad)));
        for (const auto& [x, y] : kLampCorners)
            across->push_back({x, y, glowM(lamp)});
    }
    // The shader spreads the corners, which all lie in the lamp's middle.
    const osg::ref_ptr<osg::Geometry> geometry = makeLampQuads(
        lamps, *_colours,
        [](const models::EntityLamp& lamp, float, float)
        {
            return LampCorner{osg::Vec3f(osg::Vec3d(lamp.middle.x, lamp.middle.y, lamp.middle.z)),
                              middleOfLight(lamp)};
        });
    geometry->setTexCoordArray(0, across, osg::Array::BIND_PER_VERTEX);
    geometry->setComputeBoundingBoxCallback(new GlowBound);
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    geode->setStateSet(glowState());
    _node = geode;
    light(std::vector<osg::Vec3f>(lamps.size()));
}

void LampGlow::light(const std::vector<osg::Vec3f>& lights)
{
    for (std::size_t i = 0; i < lights.size(); ++i)
        for (std::size_t corner = 0; corner < kLampCorners.size(); ++corner)
            (*_colours)[kLampCorners.size() * i + corner] = osg::Vec4f(lights[i], _edges[i]);
    _colours->dirty();
}

} // namespace scenery
