// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/ContactShadow.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/PolygonOffset>

#include "scenery/nodes/ObjectShading.h"

namespace scenery
{

namespace
{

constexpr float kRimM = 0.5F;
constexpr float kLiftM = 0.03F;
constexpr float kDarkest = 0.72F; ///< share of the light kept out in the middle

constexpr int kCells = 16; ///< each way: enough for a round rim

/// Of a place relative to the middle: full over the core, nothing from kRimM outside it on, round at the
/// corners.
float darkness(const osg::Vec2f& place, const osg::Vec2f& half)
{
    const osg::Vec2f outside(std::max(std::abs(place.x()) - half.x() + kRimM, 0.0F),
                             std::max(std::abs(place.y()) - half.y() + kRimM, 0.0F));
    return kDarkest * glm::smoothstep(2.0F * kRimM, 0.0F, outside.length());
}

} // namespace

osg::ref_ptr<osg::Node> makeContactShadow(const osg::Vec2f& middle, float halfLengthM, float halfWidthM)
{
    const osg::Vec2f half(halfLengthM, halfWidthM);
    osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array;
    osg::ref_ptr<osg::DrawElementsUShort> faces = new osg::DrawElementsUShort(GL_TRIANGLES);
    for (int i = 0; i <= kCells; ++i)
    {
        for (int j = 0; j <= kCells; ++j)
        {
            const osg::Vec2f place((half.x() + kRimM) * (2.0F * static_cast<float>(i) / kCells - 1.0F),
                                   (half.y() + kRimM) * (2.0F * static_cast<float>(j) / kCells - 1.0F));
            positions->push_back({middle.x() + place.x(), middle.y() + place.y(), kLiftM});
            colours->push_back({0.0F, 0.0F, 0.0F, darkness(place, half)});
            if (i == 0 || j == 0) continue;
            const int corner = i * (kCells + 1) + j;
            const int before = corner - kCells - 1;
            for (const int index : {corner, before - 1, before, corner, corner - 1, before - 1})
                faces->push_back(static_cast<GLushort>(index));
        }
    }
    osg::ref_ptr<osg::Vec3Array> up = new osg::Vec3Array(1);
    up->front().set(0.0F, 0.0F, 1.0F);
    osg::ref_ptr<osg::Geometry> patch = new osg::Geometry;
    patch->setVertexArray(positions);
    patch->setNormalArray(up, osg::Array::BIND_OVERALL);
    patch->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    patch->addPrimitiveSet(faces);
    patch->setUseDisplayList(false);
    patch->setUseVertexBufferObjects(true);

    osg::ref_ptr<osg::Geode> shadow = new osg::Geode;
    shadow->setName("contact shadow");
    shadow->addDrawable(patch);
    setObjectShading(*shadow, Finish::seeThrough);
    shadow->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonOffset(-2.0F, -400.0F));
    return shadow;
}

} // namespace scenery
