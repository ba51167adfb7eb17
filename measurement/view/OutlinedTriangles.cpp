// SPDX-License-Identifier: Apache-2.0
#include "measurement/view/OutlinedTriangles.h"

#include <algorithm>

#include <osg/Geometry>
#include <osg/PolygonMode>
#include <osg/PolygonOffset>

namespace measurement
{

void Soup::add(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, const osg::Vec4& colour)
{
    for (const osg::Vec3& corner : {a, b, c})
    {
        corners->push_back(corner);
        colours->push_back(colour);
    }
}

void Soup::addLit(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c)
{
    osg::Vec3 normal = (b - a) ^ (c - a);
    normal.normalize();
    const float light = 0.35F + 0.6F * std::max(normal * osg::Vec3(-0.37F, -0.45F, 0.81F), 0.0F);
    add(a, b, c, {light, light, 0.95F * light, 1.0F});
}

osg::ref_ptr<osg::Group> drawnTriangles(const Soup& soup, bool hasSides)
{
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    for (const bool isFilled : {true, false})
    {
        if (!isFilled && !hasSides) continue;
        const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        geometry->setVertexArray(soup.corners);
        const osg::ref_ptr<osg::Vec4Array> dark = new osg::Vec4Array(1);
        (*dark)[0].set(0.1F, 0.1F, 0.15F, 1.0F);
        if (isFilled)
            geometry->setColorArray(soup.colours, osg::Array::BIND_PER_VERTEX);
        else
            geometry->setColorArray(dark, osg::Array::BIND_OVERALL);
        geometry->addPrimitiveSet(
            new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(soup.corners->size())));
        osg::StateSet& state = *geometry->getOrCreateStateSet();
        state.setMode(GL_LIGHTING, osg::StateAttribute::OFF);
        if (isFilled)
            state.setAttributeAndModes(new osg::PolygonOffset(1.0F, 1.0F));
        else
            state.setAttributeAndModes(
                new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE));
        group->addChild(geometry);
    }
    return group;
}

} // namespace measurement
