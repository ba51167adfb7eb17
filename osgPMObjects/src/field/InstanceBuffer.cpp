// SPDX-License-Identifier: Apache-2.0
#include "InstanceBuffer.h"

#include <array>
#include <cstddef>

#include <osg/VertexArrayState>

#include <osgPMObjects/ObjectShader>

namespace osgPMObjects
{

namespace
{

using core::InstanceAttributes;

struct InstanceAttribute
{
    GLuint number;
    std::size_t offset;
};

/// What only instances that are being switched need comes last.
constexpr std::array<InstanceAttribute, 3> kAttributes{
    {{kPlaceAttribute, offsetof(InstanceAttributes, positionAndScale)},
     {kTurnAttribute, offsetof(InstanceAttributes, rotation)},
     {kShownAttribute, offsetof(InstanceAttributes, transition)}}};

} // namespace

void InstanceBuffer::use(osg::State& state, std::uint64_t serial,
                         std::span<const InstanceAttributes> instances)
{
    osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    Copy* copy = nullptr;
    {
        const std::lock_guard lock(_mutex);
        auto& slot = _copies[state.getContextID()];
        if (!slot) slot = std::make_unique<Copy>(state.getContextID());
        copy = slot.get();
    }
    state.unbindVertexBufferObject(); // tells OSG that what it had bound is no longer
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, copy->buffer.name(gl));
    if (copy->serial == serial) return;
    gl.glBufferData(GL_ARRAY_BUFFER_ARB, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(),
                    GL_STREAM_DRAW_ARB);
    copy->serial = serial;
}

void InstanceBuffer::pointTo(osg::GLExtensions& gl, std::uint32_t first, bool isSwitching)
{
    const std::size_t used = isSwitching ? kAttributes.size() : kAttributes.size() - 1;
    for (std::size_t i = 0; i < used; ++i)
    {
        const auto [number, offset] = kAttributes[i];
        gl.glVertexAttribPointer(number, 4, GL_FLOAT, GL_FALSE, sizeof(InstanceAttributes),
                                 osgTraversal::bufferOffset(first * sizeof(InstanceAttributes) + offset));
        gl.glVertexAttribDivisor(number, 1);
        gl.glEnableVertexAttribArray(number);
    }
}

void InstanceBuffer::end(osg::GLExtensions& gl)
{
    for (const InstanceAttribute& attribute : kAttributes)
    {
        gl.glDisableVertexAttribArray(attribute.number);
        gl.glVertexAttribDivisor(attribute.number, 0);
    }
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, 0);
}

void InstanceBuffer::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    for (auto& [contextId, copy] : _copies)
        if (!state || state->getContextID() == contextId)
        {
            copy->buffer.release();
            copy->serial = 0;
        }
}

} // namespace osgPMObjects
