// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/State>

#include <osgTraversal/ContextBuffer>

#include "IndexPacket.h"

namespace osgPMObjects
{

/// The copy of an index buffer in one graphics context.
/// Threads: as osgTraversal::ContextBuffer.
class GpuIndices
{
public:
    /// `slots`: each of three indices of `indexBytes` bytes, 2 or 4.
    GpuIndices(unsigned int contextId, std::uint32_t slots, std::size_t indexBytes)
        : _buffer(contextId), _slots(slots), _indexBytes(indexBytes)
    {
    }

    /// Returns whether upload() of a packet gives the state of the packet.
    bool canTake(const IndexPacket& packet) const
    {
        return packet.isWhole || packet.serial == _serial || (_serial != 0 && packet.serial == _serial + 1);
    }
    std::uint64_t serial() const { return _serial; } ///< the state that it holds; 0: none

    /// Writes the ranges of the packet, or nothing if it has its state already. Returns the bytes sent.
    /// Precondition: canTake(packet).
    std::size_t upload(osg::State& state, const IndexPacket& packet);

    /// Draws ranges of slots from the vertex arrays that are set.
    void draw(osg::State& state, std::span<const core::SlotRange> ranges);

    /// Passes the buffer to the deletion list of the context; the next packet has to be whole.
    void release();

private:
    osgTraversal::ContextBuffer _buffer;
    std::uint32_t _slots;
    std::size_t _indexBytes;
    std::uint64_t _serial = 0;
};

} // namespace osgPMObjects
