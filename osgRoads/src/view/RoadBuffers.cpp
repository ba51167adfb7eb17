// SPDX-License-Identifier: Apache-2.0
#include "RoadBuffers.h"

#include <algorithm>
#include <array>

#include <osg/Notify>

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
void fill(osg::GLExtensions& gl, GLenum target, std::span<const Element> elements)
{
    gl.glBufferData(target, static_cast<GLsizeiptr>(elements.size_bytes()), elements.data(),
                    GL_STATIC_DRAW_ARB);
}

void setPointers(osg::GLExtensions& gl)
{
    const GLsizei stride = sizeof(MeshVertex);
    const auto at = [](std::size_t bytes) { return bufferOffset(bytes); };
    gl.glVertexAttribIPointer(kPositionAttribute, 3, GL_INT, stride, at(offsetof(MeshVertex, position)));
    gl.glVertexAttribPointer(kPlaceAttribute, 3, GL_FLOAT, GL_FALSE, stride, at(offsetof(MeshVertex, s)));
    gl.glVertexAttribPointer(kNormalAttribute, 4, GL_BYTE, GL_TRUE, stride, at(offsetof(MeshVertex, normal)));
    gl.glVertexAttribPointer(kFlagsAttribute, 4, GL_UNSIGNED_BYTE, GL_FALSE, stride,
                             at(offsetof(MeshVertex, kind)));
    gl.glVertexAttribPointer(kRowsAttribute, 3, GL_UNSIGNED_INT, GL_FALSE, stride,
                             at(offsetof(MeshVertex, rightRow)));
}

} // namespace

RoadBuffers::RoadBuffers(std::shared_ptr<const core::PagedRoadMesh> mesh) : _mesh(std::move(mesh)) {}

RoadBuffers::Context& RoadBuffers::contextOf(osg::State& state)
{
    const std::lock_guard lock(_mutex);
    std::unique_ptr<Context>& context = _contexts[state.getContextID()];
    if (!context) context = std::make_unique<Context>();
    return *context;
}

/// Binds the buffers of a page, and fills them where they are new.
void RoadBuffers::bind(osg::State& state, Context& context, std::size_t number) const
{
    osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    Pair& pair = context.pairs.try_emplace(number, state.getContextID()).first->second;
    pair.drawn = context.draws;
    const bool isNew = !pair.vertices.isMade();
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, pair.vertices.name(gl));
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, pair.indices.name(gl));
    setPointers(gl);
    if (!isNew) return;
    auto content = _mesh->read(number);
    if (!content)
    {
        OSG_WARN
            << "roads: a kept page of their surface is damaged and is not drawn; remove the folder of kept "
               "results\n";
        const core::RoadPage& page = _mesh->pages()[number]; // its triangles are drawn, each as one point
        content.emplace();
        content->vertices.resize(1);
        content->indices.resize(page.indexCount);
    }
    fill(gl, GL_ARRAY_BUFFER_ARB, std::span<const MeshVertex>(content->vertices));
    fill(gl, GL_ELEMENT_ARRAY_BUFFER_ARB, std::span<const std::uint32_t>(content->indices));
    context.bytes += _mesh->pages()[number].bytes();
}

/// Releases pages that this draw did not need, those not drawn for longest first, until the rest is small
/// enough.
void RoadBuffers::releaseOld(Context& context) const
{
    while (context.bytes > kMostBytes)
    {
        const auto oldest =
            std::min_element(context.pairs.begin(), context.pairs.end(),
                             [](const auto& a, const auto& b) { return a.second.drawn < b.second.drawn; });
        if (oldest->second.drawn == context.draws) return;
        context.bytes -= _mesh->pages()[oldest->first].bytes();
        context.pairs.erase(oldest);
    }
}

void RoadBuffers::draw(osg::State& state, std::span<const RoadRange> ranges)
{
    osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    // An earlier drawable may have left arrays enabled that OSG switches off only with the next Geometry.
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    state.unbindElementBufferObject();
    Context& context = contextOf(state);
    ++context.draws;
    for (const GLuint attribute : kAttributes)
        gl.glEnableVertexAttribArray(attribute);
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
    for (std::size_t i = 0; i < ranges.size();)
    {
        const std::size_t number = _mesh->pageOf(ranges[i].first);
        const core::RoadPage& page = _mesh->pages()[number];
        counts.clear();
        offsets.clear();
        for (; i < ranges.size() && ranges[i].first - page.firstIndex < page.indexCount; ++i)
        {
            counts.push_back(static_cast<GLsizei>(ranges[i].count));
            offsets.push_back(bufferOffset((ranges[i].first - page.firstIndex) * sizeof(std::uint32_t)));
        }
        bind(state, context, number);
        gl.glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                               static_cast<GLsizei>(counts.size()));
    }
    for (const GLuint attribute : kAttributes)
        gl.glDisableVertexAttribArray(attribute);
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, 0);
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, 0);
    releaseOld(context);
}

std::size_t RoadBuffers::bytesOf(unsigned int contextId) const
{
    const std::lock_guard lock(_mutex);
    const auto context = _contexts.find(contextId);
    return context == _contexts.end() ? 0 : context->second->bytes;
}

void RoadBuffers::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    if (state)
        _contexts.erase(state->getContextID());
    else
        _contexts.clear();
}

} // namespace osgRoads
