// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/LampQuads.h"

namespace scenery
{

osg::ref_ptr<osg::Geometry> makeLampQuads(const std::vector<models::EntityLamp>& lamps,
                                          osg::Vec4Array& colours, const LampCornerOf& cornerOf)
{
    const osg::ref_ptr<osg::Vec3Array> places = new osg::Vec3Array, normals = new osg::Vec3Array;
    const osg::ref_ptr<osg::DrawElementsUShort> faces = new osg::DrawElementsUShort(GL_TRIANGLES);
    for (const models::EntityLamp& lamp : lamps)
    {
        const auto first = static_cast<GLushort>(places->size());
        for (const auto& [across, up] : kLampCorners)
        {
            const LampCorner corner = cornerOf(lamp, across, up);
            places->push_back(corner.place);
            normals->push_back(corner.normal);
        }
        for (const int corner : {0, 1, 2, 0, 2, 3})
            faces->push_back(static_cast<GLushort>(first + corner));
    }
    colours.resize(places->size());
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setDataVariance(osg::Object::DYNAMIC);
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(places);
    geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(&colours, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(faces);
    return geometry;
}

} // namespace scenery
