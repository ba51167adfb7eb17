// SPDX-License-Identifier: Apache-2.0
#include "MtBuffers.h"

#include <osg/GLExtensions>

namespace osgMultiTriangulation
{

namespace
{

template<class Element>
void fill(osg::GLExtensions& gl, GLenum target, const std::vector<Element>& elements)
{
    gl.glBufferData(target, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data(),
                    GL_DYNAMIC_DRAW_ARB);
}

} // namespace

MtBuffers::Copy& MtBuffers::copyOf(unsigned int contextId)
{
    const std::lock_guard lock(_mutex);
    std::unique_ptr<Copy>& copy = _copies[contextId];
    if (!copy) copy = std::make_unique<Copy>(contextId);
    return *copy;
}

void MtBuffers::draw(osg::State& state, const core::DrawnSurface& surface,
                     std::span<const std::uint32_t> cells)
{
    osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    // An earlier drawable may have left arrays enabled that OSG switches off only with the next Geometry.
    state.disableAllVertexArrays();
    state.unbindVertexBufferObject();
    state.unbindElementBufferObject();
    Copy& copy = copyOf(state.getContextID());
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, copy.vertices.name(gl));
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, copy.indices.name(gl));
    if (copy.serial != surface.serial)
    {
        fill(gl, GL_ARRAY_BUFFER_ARB, surface.vertices);
        fill(gl, GL_ELEMENT_ARRAY_BUFFER_ARB, surface.triangles);
        copy.serial = surface.serial;
    }
    gl.glVertexAttribIPointer(0, 3, GL_INT, sizeof(core::DrawnSurface::Vertex), nullptr);
    gl.glEnableVertexAttribArray(0);
    std::vector<GLsizei> counts;
    std::vector<const void*> offsets;
    for (const std::uint32_t number : cells)
    {
        const core::DrawnSurface::Cell& cell = surface.cells[number];
        counts.push_back(static_cast<GLsizei>(3 * cell.triangles));
        offsets.push_back(osgTraversal::bufferOffset(cell.firstTriangle * sizeof(core::Triangle)));
    }
    gl.glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                           static_cast<GLsizei>(counts.size()));
    gl.glDisableVertexAttribArray(0);
    gl.glBindBuffer(GL_ARRAY_BUFFER_ARB, 0);
    gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER_ARB, 0);
}

void MtBuffers::releaseGLObjects(osg::State* state)
{
    const std::lock_guard lock(_mutex);
    if (state)
        _copies.erase(state->getContextID());
    else
        _copies.clear();
}

} // namespace osgMultiTriangulation
