// SPDX-License-Identifier: Apache-2.0
#include "FieldMesh.h"

#include <limits>

#include <osg/VertexArrayState>

#include <osgPMObjects/ObjectShader>

#include "../progressive/ContextBuffer.h"
#include "MorphTargets.h"

namespace osgPMObjects
{

namespace
{

template<class Elements>
osg::ref_ptr<osg::DrawElements> elementsOf(const std::vector<core::Triangle>& faces)
{
    const osg::ref_ptr<Elements> elements = new Elements(GL_TRIANGLES);
    elements->reserve(faces.size() * 3);
    for (const core::Triangle& face : faces)
        for (const std::uint32_t wedge : face)
            elements->push_back(static_cast<typename Elements::value_type>(wedge));
    elements->setElementBufferObject(new osg::ElementBufferObject);
    return elements;
}

} // namespace

FieldMesh::FieldMesh(osg::ref_ptr<const ProgressiveShape> shape)
    : _shape(std::move(shape)), _ladder(core::LevelLadder::of(_shape->progressive(), _shape->levels()))
{
    const bool isNarrow =
        _shape->vertices().size() <= std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;
    _indices = isNarrow ? elementsOf<osg::DrawElementsUShort>(_ladder.faces)
                        : elementsOf<osg::DrawElementsUInt>(_ladder.faces);
}

void FieldMesh::addTargets()
{
    if (!_morphing.empty()) return;
    const MorphTargets targets(*_shape, _ladder);
    for (const ProgressiveShape::Group& group : _shape->groups())
        _morphing.push_back(targets.geometryOf(*group.arrays));
}

const osg::Geometry& FieldMesh::arrays(std::uint32_t group, bool withTargets) const
{
    return withTargets && !_morphing.empty() ? *_morphing[group] : *_shape->groups()[group].arrays;
}

void FieldMesh::draw(osg::State& state, std::uint32_t rung, std::uint32_t group,
                     std::uint32_t instances) const
{
    const core::SlotRange faces = _ladder.facesOf(rung, group);
    if (faces.count == 0) return;
    osg::GLBufferObject* const buffer = _indices->getOrCreateGLBufferObject(state.getContextID());
    state.getCurrentVertexArrayState()->bindElementBufferObject(buffer);
    const std::size_t indexBytes = _indices->getTotalDataSize() / std::max(1u, _indices->getNumIndices());
    const std::size_t offset = static_cast<std::size_t>(buffer->getOffset(_indices->getBufferIndex())) +
                               std::size_t{faces.first} * 3 * indexBytes;
    state.glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(faces.count * 3),
                                  _indices->getDataType(), bufferOffset(offset),
                                  static_cast<GLsizei>(instances));
}

void FieldMesh::resizeGLObjectBuffers(unsigned int contexts) const
{
    _shape->resizeGLObjectBuffers(contexts);
    _indices->resizeGLObjectBuffers(contexts);
    for (const auto& geometry : _morphing)
        geometry->resizeGLObjectBuffers(contexts);
}

void FieldMesh::releaseGLObjects(osg::State* state) const
{
    _shape->releaseGLObjects(state);
    _indices->releaseGLObjects(state);
    for (const auto& geometry : _morphing)
        geometry->releaseGLObjects(state);
}

} // namespace osgPMObjects
