// SPDX-License-Identifier: Apache-2.0
#include "RoadBuffers.h"

#include <array>

#include <osgRoads/RoadShader>

namespace osgRoads
{

namespace
{

using core::MeshVertex;
using osgTraversal::bufferOffset;

constexpr std::array kAttributes{kPositionAttribute, kPlaceAttribute, kNormalAttribute, kFlagsAttribute,
                                 kRowsAttribute};

template<class Element>
void fill(osg::GLExtensions& gl, GLenum target, const std::vector<Element>& elements)
{
    gl.glBufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(),
                    GL_STATIC_DRAW_ARB);
}

void setPointers(osg::GLExtensions& gl)
{
    const GLsizei stride = sizeof(MeshVertex);
    const auto at = [](std::size_t bytes) { return bufferOffset(bytes); };
    gl.glVertexAttribIPointer(kPositionAttribute, 3, GL_INT, stride, at(offsetof(MeshVertex, position)));
    gl.glVertexAttribPointer(kPlaceAttribute, 3, GL_FLOAT, GL_FALSE, stride, at(offsetof(MeshVertex, s)));
    gl.glVertexAttribPointer(kNormalAttribute, 3, GL_BYTE, GL_TRUE, stride, at(offsetof(MeshVertex, normal)));
    gl.glVertexAttribPointer(kFlagsAttribute, 4, GL_UNSIGNED_BYTE, GL_FALSE, stride,
                             at(offsetof(MeshVertex, kind)));
    gl.glVertexAttribPointer(kRowsAttribute, 3, GL_UNSIGNED_INT, GL_FALSE, stride,
                             at(offsetof(MeshVertex, rightRow)));
}

} // namespace

RoadBuffers::Pair& RoadBuffers::pairOf(osg::State& state)
{
    const std::lock_guard lock(_mutex);
    std::unique_ptr<Pair>& pair = _pairs[state.getContextID()];
    if (!pair) pair = std::make_unique<Pair>(state.getContextID());
    return *pair;
}

void RoadBuffers::draw(osg::State& state, const std::vector<RoadRange>& ranges)
{
    osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    // An earlier drawable may have left arrays enabled that OSG switches off only with the next Geometry.
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    state.unbindElementBufferObject();
    Pair& pair = pairOf(state);
    const bool isNew = !pair.vertices.isMade();
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, pair.vertices.name(gl));
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, pair.indices.name(gl));
    if (isNew)
    {
        fill(gl, GL_ARRAY_BUFFER_ARB, _mesh->vertices);
        fill(gl, GL_ELEMENT_ARRAY_BUFFER_ARB, _mesh->indices);
    }
    setPointers(gl);
    for (const GLuint attribute : kAttributes)
        gl.glEnableVertexAttribArray(attribute);
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
    for (const RoadRange& range : ranges)
    {
        counts.push_back(static_cast<GLsizei>(range.count));
        offsets.push_back(bufferOffset(range.first * sizeof(std::uint32_t)));
    }
    gl.glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                           static_cast<GLsizei>(counts.size()));
    for (const GLuint attribute : kAttributes)
        gl.glDisableVertexAttribArray(attribute);
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, 0);
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, 0);
}

void RoadBuffers::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    if (state)
        _pairs.erase(state->getContextID());
    else
        _pairs.clear();
}

} // namespace osgRoads
