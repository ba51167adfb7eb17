// SPDX-License-Identifier: Apache-2.0
#include "LevelPart.h"

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

LevelPart::LevelPart(std::shared_ptr<ViewLevel> level, DrawnLevelPtr drawn, std::uint32_t group,
                     MorphArraysPtr morph)
    : GroupPart(&level->shape(), group, std::move(morph)), _level(std::move(level)), _drawn(std::move(drawn))
{
}

void LevelPart::drawFaces(osg::State& state) const
{
    _level->draw(state, *_drawn, group());
}

void LevelPart::accept(osg::PrimitiveFunctor& functor) const
{
    showFaces(*_level, group(), functor);
}

void LevelPart::accept(osg::PrimitiveIndexFunctor& functor) const
{
    showFaces(*_level, group(), functor);
}

} // namespace osgPMObjects
