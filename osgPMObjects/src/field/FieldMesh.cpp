// SPDX-License-Identifier: Apache-2.0
#include "FieldMesh.h"

#include <limits>

#include <osg/VertexArrayState>

#include <osgPMObjects/ObjectShader>
#include <osgTraversal/ContextBuffer>

#include "FinestFaces.h"
#include "LadderTargets.h"

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
    : _shape(shape),
      _levels(_shape->fieldLevels() ? _shape->fieldLevels()
                                    : std::make_shared<const core::FieldLevels>(
                                          core::FieldLevels::of(_shape->progressive(), _shape->levels())))
{
    addArrays();
    const bool isNarrow =
        _shape->vertices().size() <= std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1;
    _indices = isNarrow ? elementsOf<osg::DrawElementsUShort>(_levels->ladder.faces)
                        : elementsOf<osg::DrawElementsUInt>(_levels->ladder.faces);
}

/// The shape's, with the offsets of leaves where there are some.
void FieldMesh::addArrays()
{
    osg::ref_ptr<osg::Vec3Array> offsets;
    if (!_levels->growth.offsets.empty())
    {
        offsets = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
        for (const glm::vec3& offset : _levels->growth.offsets)
            offsets->push_back({offset.x, offset.y, offset.z});
        offsets->setVertexBufferObject(new osg::VertexBufferObject);
    }
    const auto grows = [&](std::uint32_t group)
    {
        for (std::size_t i = group; i < _levels->growth.scales.size(); i += _levels->ladder.groups)
            if (_levels->growth.scales[i] != 1.0F) return true;
        return false;
    };
    for (std::uint32_t group = 0; group < _shape->groups().size(); ++group)
    {
        _settled.push_back(_shape->groups()[group].arrays);
        if (!grows(group)) continue;
        _settled.back() = new osg::Geometry(*_settled.back(), osg::CopyOp::SHALLOW_COPY);
        _settled.back()->setVertexAttribArray(kLeafOffsetAttribute, offsets);
    }
}

bool FieldMesh::hasLeaves(std::uint32_t group) const
{
    return _settled[group] != _shape->groups()[group].arrays;
}

void FieldMesh::addTargets()
{
    if (!_morphing.empty()) return;
    const LadderTargets targets(*_shape, _levels->ladder);
    for (const auto& arrays : _settled)
        _morphing.push_back(targets.geometryOf(*arrays));
}

const osg::Geometry& FieldMesh::arrays(std::uint32_t group, bool withTargets) const
{
    return withTargets && !_morphing.empty() ? *_morphing[group] : *_settled[group];
}

void FieldMesh::draw(osg::State& state, std::uint32_t rung, std::uint32_t group,
                     std::uint32_t instances) const
{
    const core::SlotRange faces = _levels->ladder.facesOf(rung, group);
    if (faces.count == 0) return;
    if (hasLeaves(group))
    {
        const auto scaleAt = [&](std::size_t r)
        {
            return _levels->growth
                .scales[std::min(r, _levels->ladder.rungs.size() - 1) * _levels->ladder.groups + group];
        };
        state.get<osg::GLExtensions>()->glVertexAttrib2f(kLeafScaleAttribute, scaleAt(rung),
                                                         scaleAt(rung + 1));
    }
    osg::GLBufferObject* const buffer = _indices->getOrCreateGLBufferObject(state.getContextID());
    state.getCurrentVertexArrayState()->bindElementBufferObject(buffer);
    const std::size_t indexBytes = _indices->getTotalDataSize() / std::max(1u, _indices->getNumIndices());
    const std::size_t offset = static_cast<std::size_t>(buffer->getOffset(_indices->getBufferIndex())) +
                               std::size_t{faces.first} * 3 * indexBytes;
    // osg::State has it inline, and with it glDrawElements(), which whoever uses a field would have to link.
    state.get<osg::GLExtensions>()->glDrawElementsInstanced(
        GL_TRIANGLES, static_cast<GLsizei>(faces.count * 3), _indices->getDataType(),
        osgTraversal::bufferOffset(offset), static_cast<GLsizei>(instances));
}

const std::vector<osg::ref_ptr<osg::Geometry>>& FieldMesh::finest() const
{
    std::call_once(_finestMade, [this] { _finest = finestFaces(*_shape, _levels->ladder); });
    return _finest;
}

void FieldMesh::resizeGLObjectBuffers(unsigned int contexts) const
{
    _shape->resizeGLObjectBuffers(contexts);
    _indices->resizeGLObjectBuffers(contexts);
    for (const auto& geometry : _settled)
        geometry->resizeGLObjectBuffers(contexts);
    for (const auto& geometry : _morphing)
        geometry->resizeGLObjectBuffers(contexts);
}

void FieldMesh::releaseGLObjects(osg::State* state) const
{
    _shape->releaseGLObjects(state);
    _indices->releaseGLObjects(state);
    for (const auto& geometry : _settled)
        geometry->releaseGLObjects(state);
    for (const auto& geometry : _morphing)
        geometry->releaseGLObjects(state);
}

} // namespace osgPMObjects
