// SPDX-License-Identifier: Apache-2.0
#include "GpuIndices.h"

#include <cassert>

namespace osgPMObjects
{

std::size_t GpuIndices::upload(osg::State& state, const IndexPacket& packet)
{
    assert(canTake(packet));
    if (packet.serial == _serial) return 0;
    osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    const std::size_t slotBytes = 3 * _indexBytes;
    state.unbindElementBufferObject();
    const bool isNew = !_buffer.isMade();
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, _buffer.name(gl));
    if (isNew)
        gl.glBufferData(GL_ELEMENT_ARRAY_BUFFER_ARB, static_cast<GLsizeiptr>(_slots * slotBytes), nullptr,
                        GL_DYNAMIC_DRAW_ARB);
    const std::byte* source = packet.bytes.data();
    for (const core::SlotRange& range : packet.ranges)
    {
        gl.glBufferSubData(GL_ELEMENT_ARRAY_BUFFER_ARB, static_cast<GLintptr>(range.first * slotBytes),
                           static_cast<GLsizeiptr>(range.count * slotBytes), source);
        source += range.count * slotBytes;
    }
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, 0);
    _serial = packet.serial;
    return packet.bytes.size();
}

void GpuIndices::draw(osg::State& state, std::span<const core::SlotRange> ranges)
{
    if (ranges.empty() || _serial == 0) return;
    osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
    for (const core::SlotRange& range : ranges)
    {
        counts.push_back(static_cast<GLsizei>(range.count * 3));
        offsets.push_back(osgTraversal::bufferOffset(range.first * 3 * _indexBytes));
    }
    state.unbindElementBufferObject();
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, _buffer.name(gl));
    gl.glMultiDrawElements(GL_TRIANGLES, counts.data(),
                           _indexBytes == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT, offsets.data(),
                           static_cast<GLsizei>(counts.size()));
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, 0);
}

void GpuIndices::release()
{
    _buffer.release();
    _serial = 0;
}

} // namespace osgPMObjects
