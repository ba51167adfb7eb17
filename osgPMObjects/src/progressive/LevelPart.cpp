// SPDX-License-Identifier: Apache-2.0
#include "LevelPart.h"

#include <osg/VertexArrayState>

namespace osgPMObjects
{

namespace
{

template<class Functor>
void show(const ViewLevel& level, std::optional<std::uint32_t> group, Functor& functor)
{
    std::vector<GLuint> indices;
    level.visitFaces(
        [&](const core::Triangle& face, std::uint32_t of)
        {
            if (group && of != *group) return;
            indices.insert(indices.end(), face.begin(), face.end());
        });
    if (indices.empty()) return;
    const osg::Vec3Array& vertices = level.shape().vertices();
    functor.setVertexArray(static_cast<unsigned>(vertices.size()), vertices.asVector().data());
    functor.drawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), indices.data());
}

} // namespace

void showFaces(const ViewLevel& level, std::optional<std::uint32_t> group, osg::PrimitiveFunctor& functor)
{
    show(level, group, functor);
}

void showFaces(const ViewLevel& level, std::optional<std::uint32_t> group,
               osg::PrimitiveIndexFunctor& functor)
{
    show(level, group, functor);
}

LevelPart::LevelPart(std::shared_ptr<ViewLevel> level, DrawnLevelPtr drawn, std::uint32_t group)
    : _level(std::move(level)), _drawn(std::move(drawn)), _group(group)
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    setUseVertexBufferObjects(true);
    setUseVertexArrayObject(false);
    setDataVariance(osg::Object::STATIC);
    setCullingActive(false); // whoever puts it in has looked
}

void LevelPart::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    osg::VertexArrayState* const arrays = state.getCurrentVertexArrayState();
    arrays->setVertexBufferObjectSupported(true);
    _level->shape().groups()[_group].arrays->drawVertexArraysImplementation(renderInfo);
    _level->draw(state, *_drawn, _group);
    arrays->unbindVertexBufferObject();
    arrays->unbindElementBufferObject();
}

osg::BoundingBox LevelPart::computeBoundingBox() const
{
    return _level->shape().groups()[_group].box;
}

void LevelPart::accept(osg::PrimitiveFunctor& functor) const
{
    showFaces(*_level, _group, functor);
}

void LevelPart::accept(osg::PrimitiveIndexFunctor& functor) const
{
    showFaces(*_level, _group, functor);
}

} // namespace osgPMObjects
