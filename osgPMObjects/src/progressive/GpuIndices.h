// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/GLExtensions>
#include <osg/GLObjects>
#include <osg/State>

#include "IndexPacket.h"

namespace osgPMObjects
{

/// One graphics context's copy of an index buffer.
/// Threads: the context's draw thread. The buffer goes back through the context's own deletion list, from any thread.
class GpuIndices
{
public:
    /// `slots` of three indices of `indexBytes` each, 2 or 4.
    GpuIndices(unsigned int contextId, std::uint32_t slots, std::size_t indexBytes)
        : _contextId(contextId), _slots(slots), _indexBytes(indexBytes)
    {
    }
    ~GpuIndices() { release(); }
    GpuIndices(const GpuIndices&) = delete;
    GpuIndices& operator=(const GpuIndices&) = delete;

    /// Whether upload() of a packet leads to its state.
    bool canTake(const IndexPacket& packet) const
    {
        return packet.isWhole || packet.serial == _serial || (_serial != 0 && packet.serial == _serial + 1);
    }
    std::uint64_t serial() const { return _serial; } ///< state of what it holds; 0: nothing

    /// Writes the packet's ranges (none when it is there already). Returns the bytes sent.
    /// Precondition: canTake(packet).
    std::size_t upload(osg::State& state, const IndexPacket& packet);

    /// Draws ranges of slots from the vertex arrays that are set.
    void draw(osg::State& state, std::span<const core::SlotRange> ranges) const;

    /// Hands the buffer to the deletion list of the context; the next packet has to be whole.
    void release();

private:
    unsigned int _contextId;
    std::uint32_t _slots;
    std::size_t _indexBytes;
    osg::ref_ptr<osg::GLObjectManager> _deletion; ///< found in the draw thread: only there may OSG make one
    GLuint _buffer = 0;
    std::uint64_t _serial = 0;
};

} // namespace osgPMObjects
