// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/State>

#include <osgTraversal/ContextBuffer>

#include "IndexPacket.h"

namespace osgPMObjects
{

/// One graphics context's copy of an index buffer.
/// Threads: as osgTraversal::ContextBuffer.
class GpuIndices
{
public:
    /// `slots` of three indices of `indexBytes` each, 2 or 4.
    GpuIndices(unsigned int contextId, std::uint32_t slots, std::size_t indexBytes)
        : _buffer(contextId), _slots(slots), _indexBytes(indexBytes)
    {
    }

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
    void draw(osg::State& state, std::span<const core::SlotRange> ranges);

    /// Hands the buffer to the deletion list of the context; the next packet has to be whole.
    void release();

private:
    osgTraversal::ContextBuffer _buffer;
    std::uint32_t _slots;
    std::size_t _indexBytes;
    std::uint64_t _serial = 0;
};

} // namespace osgPMObjects
