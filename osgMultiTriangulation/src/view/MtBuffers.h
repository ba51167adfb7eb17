// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>

#include <osg/State>

#include <osgMultiTriangulation/core/follow/DrawnSurface.h>

#include <osgTraversal/ContextBuffer>

namespace osgMultiTriangulation
{

/// The newest surface of a view group in the graphics contexts.
/// Threads: draw() in draw threads; release from any.
class MtBuffers
{
public:
    /// Draws cells of a surface, by their numbers; uploads it first where the context has another.
    void draw(osg::State& state, const core::DrawnSurface& surface, std::span<const std::uint32_t> cells);

    /// Releases what a context has, or what all have.
    void releaseGLObjects(osg::State* state);

private:
    struct Copy
    {
        explicit Copy(unsigned int contextId) : vertices(contextId), indices(contextId) {}
        osgTraversal::ContextBuffer vertices, indices;
        std::uint64_t serial = 0;
    };

    Copy& copyOf(unsigned int contextId);

    std::mutex _mutex; ///< guards the map
    std::map<unsigned int, std::unique_ptr<Copy>> _copies;
};

} // namespace osgMultiTriangulation
