// SPDX-License-Identifier: Apache-2.0
#include "StillLevel.h"

namespace osgPMObjects
{

namespace
{

osg::ref_ptr<osg::DrawElements> emptyFaces(bool isNarrow)
{
    osg::ref_ptr<osg::DrawElements> faces;
    if (isNarrow)
        faces = new osg::DrawElementsUShort(GL_TRIANGLES);
    else
        faces = new osg::DrawElementsUInt(GL_TRIANGLES);
    faces->setElementBufferObject(new osg::ElementBufferObject);
    return faces;
}

} // namespace

StillPart::StillPart(osg::ref_ptr<const ProgressiveShape> shape, std::uint32_t group,
                     osg::ref_ptr<const osg::DrawElements> faces)
    : GroupPart(shape, group, nullptr), _faces(faces)
{
}

void StillPart::drawFaces(osg::State& state) const
{
    _faces->draw(state, true);
}

void StillPart::accept(osg::PrimitiveFunctor& functor) const
{
    functor.setVertexArray(static_cast<unsigned>(shape().vertices().size()),
                           shape().vertices().asVector().data());
    _faces->accept(functor);
}

void StillPart::accept(osg::PrimitiveIndexFunctor& functor) const
{
    functor.setVertexArray(static_cast<unsigned>(shape().vertices().size()),
                           shape().vertices().asVector().data());
    _faces->accept(functor);
}

StillLevel::StillLevel(const ViewLevel& level, std::uint32_t steps) : _steps(steps)
{
    const ProgressiveShape& shape = level.shape();
    const bool isNarrow = shape.vertices().size() <= 0x10000;
    std::vector<osg::ref_ptr<osg::DrawElements>> byGroup(shape.groups().size());
    level.visitFaces(
        [&](const core::Triangle& face, std::uint32_t group)
        {
            if (!byGroup[group]) byGroup[group] = emptyFaces(isNarrow);
            for (const std::uint32_t wedge : face)
                byGroup[group]->addElement(wedge);
            ++_triangles;
        });
    for (std::uint32_t group = 0; group < byGroup.size(); ++group)
        if (byGroup[group]) _parts.push_back(new StillPart(&shape, group, byGroup[group]));
}

} // namespace osgPMObjects
