// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/EntityLamps.h"

#include <osg/Geode>

#include "scenery/nodes/RoadLamps.h"

namespace scenery
{

namespace
{

constexpr std::size_t kCorners = 4; ///< of a lamp

/// Returns the light of a lamp, linear: 1 is about that of a white wall in the sun.
osg::Vec4f lightOf(models::EntityLamp::Kind kind)
{
    using Kind = models::EntityLamp::Kind;
    switch (kind)
    {
    case Kind::head:
        return {1.5F, 1.45F, 1.25F, 1.0F};
    case Kind::tail:
        return {0.45F, 0.015F, 0.01F, 1.0F};
    case Kind::brake:
        return {1.4F, 0.05F, 0.03F, 1.0F};
    case Kind::indicatorLeft:
    case Kind::indicatorRight:
        return {1.4F, 0.50F, 0.02F, 1.0F};
    case Kind::warning:
        return {0.05F, 0.15F, 1.5F, 1.0F};
    default:
        return {1.2F, 1.2F, 1.15F, 1.0F};
    }
}

} // namespace

models::LitLamps usualLamps(const simulation::EntityState& state, bool isDark)
{
    using Kind = models::EntityLamp::Kind;
    constexpr double kBrakingMps2 = 0.5, kStandingMps = 0.05;
    const double ahead = glm::dot(state.acceleration, state.bodyToLocal()[0]);
    const auto at = [](Kind kind) { return static_cast<std::size_t>(kind); };
    models::LitLamps lit{};
    lit[at(Kind::brake)] = state.speedMps > kStandingMps && ahead < -kBrakingMps2;
    lit[at(Kind::reversing)] = state.speedMps < -kStandingMps;
    lit[at(Kind::head)] = lit[at(Kind::tail)] = isDark;
    return lit;
}

EntityLamps::EntityLamps(std::vector<models::EntityLamp> lamps) : _lamps(std::move(lamps))
{
    if (_lamps.empty()) return;
    const osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array, normals = new osg::Vec3Array;
    const osg::ref_ptr<osg::DrawElementsUShort> faces = new osg::DrawElementsUShort(GL_TRIANGLES);
    for (const models::EntityLamp& lamp : _lamps)
    {
        const double ahead = lamp.looksAhead ? 1.0 : -1.0;
        const auto first = static_cast<GLushort>(corners->size());
        for (const auto& [across, up] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
        {
            const osg::Vec3d at(lamp.middle.x + ahead * across * lamp.sweepM,
                                lamp.middle.y + ahead * across * lamp.widthM,
                                lamp.middle.z + up * lamp.heightM);
            corners->push_back(osg::Vec3f(at));
            normals->push_back(osg::Vec3f(static_cast<float>(ahead), 0.0F, 0.0F));
            _colours->push_back({});
        }
        for (const int corner : {0, 1, 2, 0, 2, 3})
            faces->push_back(static_cast<GLushort>(first + corner));
    }
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setDataVariance(osg::Object::DYNAMIC);
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(corners);
    geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(_colours, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(faces);
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    geode->getOrCreateStateSet()->setAttributeAndModes(makeRoadLampProgram());
    geode->setNodeMask(0); // all are dark
    _node = geode;
}

void EntityLamps::light(const models::LitLamps& lit)
{
    if (!_node || lit == _lit) return;
    _lit = lit;
    bool isAnyLit = false;
    for (std::size_t i = 0; i < _lamps.size(); ++i)
    {
        const bool isLit = lit[static_cast<std::size_t>(_lamps[i].kind)];
        isAnyLit = isAnyLit || isLit;
        for (std::size_t corner = 0; corner < kCorners; ++corner)
            (*_colours)[kCorners * i + corner] = isLit ? lightOf(_lamps[i].kind) : osg::Vec4f();
    }
    _colours->dirty();
    _node->setNodeMask(isAnyLit ? ~0U : 0U);
}

} // namespace scenery
