// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <osg/State>

#include <osgTraversal/ContextBuffer>

#include "MeshPacket.h"

namespace osgTerrainROAM
{

/// The copy of a mesh in one graphics context: a vertex buffer and an index buffer.
/// Threads: as osgTraversal::ContextBuffer.
class GpuMesh
{
public:
    explicit GpuMesh(unsigned int contextId) : _vertexBuffer(contextId), _indexBuffer(contextId) {}

    /// Whether upload(packet) leads to the packet's state.
    bool canTake(const MeshPacket& packet) const;

    /// Writes the packet's ranges (none when it is there already). Returns the bytes sent.
    /// Precondition: canTake(packet).
    std::size_t upload(osg::State& state, const MeshPacket& packet);

    /// Draws ranges of triangles, or of patches, with the vertex attributes 0 (position, integer) and 1
    /// (grid).
    void draw(osg::State& state, std::span<const core::IndexRange> ranges);

    /// Hands the buffers to the deletion list of the context; the next packet has to be whole.
    void release();

private:
    void bind(osg::GLExtensions& gl);
    void allocate(osg::GLExtensions& gl, const MeshPacket& packet);
    void drawTriangles(osg::GLExtensions& gl, std::span<const core::IndexRange> ranges) const;
    void drawPatches(osg::GLExtensions& gl, std::span<const core::IndexRange> ranges) const;

    osgTraversal::ContextBuffer _vertexBuffer;
    osgTraversal::ContextBuffer _indexBuffer;
    std::uint32_t _vertexCapacity = 0;
    std::uint32_t _triangleCapacity = 0;
    int _patchExponent = 0;    ///< of what the buffers hold
    std::uint64_t _serial = 0; ///< state of the mesh in the buffers; 0: none
};

} // namespace osgTerrainROAM
