// SPDX-License-Identifier: Apache-2.0
#include "GpuMesh.h"

#include <cassert>
#include <vector>

namespace osgTerrainROAM
{

namespace
{

using osgTraversal::bufferOffset;

template<class Element>
std::size_t uploadRanges(osg::GLExtensions& gl, GLenum target, const std::vector<core::IndexRange>& ranges,
                         const std::vector<Element>& elements)
{
    const Element* source = elements.data();
    for (const core::IndexRange& range : ranges)
    {
        gl.glBufferSubData(target, static_cast<GLintptr>(range.first * sizeof(Element)),
                           static_cast<GLsizeiptr>(range.count * sizeof(Element)), source);
        source += range.count;
    }
    return elements.size() * sizeof(Element);
}

} // namespace

bool GpuMesh::canTake(const MeshPacket& packet) const
{
    if (packet.whole || packet.serial == _serial) return true;
    return packet.serial == _serial + 1 && _serial != 0 && packet.vertexCount <= _vertexCapacity &&
           packet.triangleCount <= _triangleCapacity;
}

void GpuMesh::bind(osg::GLExtensions& gl)
{
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, _vertexBuffer.name(gl));
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, _indexBuffer.name(gl));
}

void GpuMesh::allocate(osg::GLExtensions& gl, const MeshPacket& packet)
{
    bind(gl);
    const std::uint32_t vertices = bufferCapacity(packet.vertexCount);
    const std::uint32_t triangles = bufferCapacity(packet.triangleCount);
    if (vertices != _vertexCapacity)
        gl.glBufferData(GL_ARRAY_BUFFER_ARB, static_cast<GLsizeiptr>(vertices * sizeof(core::MeshVertex)),
                        nullptr, GL_DYNAMIC_DRAW_ARB);
    if (triangles != _triangleCapacity)
        gl.glBufferData(GL_ELEMENT_ARRAY_BUFFER_ARB,
                        static_cast<GLsizeiptr>(triangles * sizeof(core::LeafTriangle)), nullptr,
                        GL_DYNAMIC_DRAW_ARB);
    _vertexCapacity = vertices;
    _triangleCapacity = triangles;
}

std::size_t GpuMesh::upload(osg::State& state, const MeshPacket& packet)
{
    assert(canTake(packet));
    if (packet.serial == _serial) return 0;
    osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    state.unbindVertexBufferObject();
    state.unbindElementBufferObject();
    if (packet.whole) allocate(gl, packet);
    _patchExponent = packet.patchExponent;
    bind(gl);
    const std::size_t bytes =
        uploadRanges(gl, GL_ARRAY_BUFFER_ARB, packet.vertexRanges, packet.vertices) +
        uploadRanges(gl, GL_ELEMENT_ARRAY_BUFFER_ARB, packet.triangleRanges, packet.triangles);
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, 0);
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, 0);
    _serial = packet.serial;
    return bytes;
}

void GpuMesh::draw(osg::State& state, std::span<const core::IndexRange> ranges)
{
    if (ranges.empty() || _serial == 0) return;
    osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    // An earlier drawable may have left arrays enabled that OSG switches off only with the next Geometry.
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    state.unbindElementBufferObject();
    bind(gl);
    const GLsizei stride = sizeof(core::MeshVertex);
    gl.glVertexAttribIPointer(0, 3, GL_INT, stride, bufferOffset(offsetof(core::MeshVertex, position)));
    gl.glVertexAttribPointer(1, 2, GL_UNSIGNED_SHORT, GL_FALSE, stride,
                             bufferOffset(offsetof(core::MeshVertex, grid)));
    for (const GLuint attribute : {0u, 1u})
        gl.glEnableVertexAttribArray(attribute);
    if (_patchExponent > 0)
        drawPatches(gl, ranges);
    else
        drawTriangles(gl, ranges);
    for (const GLuint attribute : {0u, 1u})
        gl.glDisableVertexAttribArray(attribute);
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, 0);
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, 0);
}

void GpuMesh::drawTriangles(osg::GLExtensions& gl, std::span<const core::IndexRange> ranges) const
{
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
    for (const core::IndexRange& range : ranges)
    {
        counts.push_back(static_cast<GLsizei>(range.count * 3));
        offsets.push_back(bufferOffset(range.first * sizeof(core::LeafTriangle)));
    }
    gl.glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                           static_cast<GLsizei>(counts.size()));
}

/// One patch's triangles serve all: each draw counts from its own patch's first vertex.
void GpuMesh::drawPatches(osg::GLExtensions& gl, std::span<const core::IndexRange> ranges) const
{
    const core::PatchShape& shape = core::PatchShape::of(_patchExponent);
    std::vector<GLint> firstVertices;
    for (const core::IndexRange& range : ranges)
        for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
            firstVertices.push_back(static_cast<GLint>(slot * shape.vertices.size()));
    const std::vector<GLsizei> counts(firstVertices.size(), static_cast<GLsizei>(3 * shape.triangles.size()));
    const std::vector<const void*> offsets(firstVertices.size(), nullptr);
    gl.glMultiDrawElementsBaseVertex(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                                     static_cast<GLsizei>(counts.size()), firstVertices.data());
}

void GpuMesh::release()
{
    _vertexBuffer.release();
    _indexBuffer.release();
    _vertexCapacity = _triangleCapacity = 0;
    _serial = 0;
}

} // namespace osgTerrainROAM
