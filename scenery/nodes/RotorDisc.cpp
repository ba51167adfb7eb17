// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/RotorDisc.h"

#include <array>
#include <cmath>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Math>

#include "scenery/nodes/ObjectShading.h"

namespace scenery
{

osg::ref_ptr<osg::Node> makeRotorDisc(const models::EntityRotor& rotor)
{
    constexpr int kDiscSides = 48;
    const auto hubShare = static_cast<float>(rotor.hubRadiusM / rotor.radiusM),
               radius = static_cast<float>(rotor.radiusM);
    const std::array<std::pair<float, float>, 4> rims = {
        {{hubShare, 0.30F}, {0.62F, 0.16F}, {0.96F, 0.20F}, {1.0F, 0.0F}}}; // with alpha
    const osg::Vec3f axis(osg::Vec3d(rotor.axis.x, rotor.axis.y, rotor.axis.z));
    const osg::Vec3f hub(osg::Vec3d(rotor.hub.x, rotor.hub.y, rotor.hub.z));
    osg::Vec3f a =
        axis ^ (std::abs(axis.z()) > 0.9F ? osg::Vec3f(1.0F, 0.0F, 0.0F) : osg::Vec3f(0.0F, 0.0F, 1.0F));
    a.normalize();
    const osg::Vec3f b = axis ^ a;
    osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
    osg::ref_ptr<osg::DrawElementsUShort> faces = new osg::DrawElementsUShort(GL_TRIANGLES);
    for (std::size_t r = 0; r < rims.size(); ++r)
        for (int i = 0; i <= kDiscSides; ++i)
        {
            const double angle = 2.0 * osg::PI * i / kDiscSides;
            const osg::Vec3f out =
                a * static_cast<float>(std::cos(angle)) + b * static_cast<float>(std::sin(angle));
            positions->push_back(hub + out * (rims[r].first * radius));
            colours->push_back({0.25F, 0.25F, 0.26F, rims[r].second});
            if (r == 0 || i == 0) continue;
            const int corner = static_cast<int>(r) * (kDiscSides + 1) + i;
            const int inner = corner - kDiscSides - 1;
            for (const int index : {corner, inner, inner - 1, corner, inner - 1, corner - 1})
                faces->push_back(static_cast<GLushort>(index));
        }
    osg::ref_ptr<osg::Vec3Array> normal = new osg::Vec3Array(1);
    normal->front() = axis;
    osg::ref_ptr<osg::Geometry> disc = new osg::Geometry;
    disc->setVertexArray(positions);
    disc->setNormalArray(normal, osg::Array::BIND_OVERALL);
    disc->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    disc->addPrimitiveSet(faces);
    disc->setUseDisplayList(false);
    disc->setUseVertexBufferObjects(true);
    osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->setName("rotor disc");
    node->addDrawable(disc);
    setObjectShading(*node, Finish::seeThrough);
    node->getOrCreateStateSet()->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    return node;
}

} // namespace scenery
