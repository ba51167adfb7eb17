// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/LampGlow.h"

#include <cmath>
#include <numbers>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Geode>
#include <osg/Program>

#include <osgTerrainROAM/Atmosphere>
#include <shaders/scenery.h>

namespace scenery
{

namespace
{

constexpr std::size_t kGlowCorners = 4;

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
    program->addShader(new osg::Shader(
        osg::Shader::FRAGMENT, version + osgTerrainROAM::Atmosphere::glslFunctions() + shaders::kGlowMain));
    return program;
}

LampGlow::LampGlow(const std::vector<models::EntityLamp>& lamps)
{
    const osg::ref_ptr<osg::Vec3Array> middles = new osg::Vec3Array, normals = new osg::Vec3Array,
                                       across = new osg::Vec3Array;
    const osg::ref_ptr<osg::DrawElementsUShort> faces = new osg::DrawElementsUShort(GL_TRIANGLES);
    for (const models::EntityLamp& lamp : lamps)
    {
        _edges.push_back(
            lamp.halfAngleRad >= std::numbers::pi ? -1.0F : static_cast<float>(std::cos(lamp.halfAngleRad)));
        const auto first = static_cast<GLushort>(middles->size());
        for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}})
        {
            middles->push_back(osg::Vec3f(osg::Vec3d(lamp.middle.x, lamp.middle.y, lamp.middle.z)));
            normals->push_back(middleOfLight(lamp));
            across->push_back({x, y, glowM(lamp)});
            _colours->push_back({0.0F, 0.0F, 0.0F, _edges.back()});
        }
        for (const int corner : {0, 1, 2, 0, 2, 3})
            faces->push_back(static_cast<GLushort>(first + corner));
    }
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setDataVariance(osg::Object::DYNAMIC);
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(middles);
    geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, across, osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(_colours, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(faces);
    geometry->setComputeBoundingBoxCallback(new GlowBound);
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    geode->setStateSet(glowState());
    _node = geode;
}

void LampGlow::light(const std::vector<osg::Vec3f>& lights)
{
    for (std::size_t i = 0; i < lights.size(); ++i)
        for (std::size_t corner = 0; corner < kGlowCorners; ++corner)
            (*_colours)[kGlowCorners * i + corner] = osg::Vec4f(lights[i], _edges[i]);
    _colours->dirty();
}

} // namespace scenery
