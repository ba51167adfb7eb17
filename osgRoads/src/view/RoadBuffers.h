// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include <osg/State>

#include <osgRoads/core/surface/PagedRoadMesh.h>

#include <osgTraversal/ContextBuffer>

namespace osgRoads
{

/// A range of a mesh's indices.
struct RoadRange
{
    std::uint32_t first = 0, count = 0;
};

/// The buffers of a road mesh in the graphics contexts. A context has the pages that were drawn, so that of a
/// large network only the surroundings of its eyes are there. Beyond kMostBytes pages that have not been
/// drawn for longest are released. A page whose bytes are damaged is not drawn, which is told once.
/// Threads: draw() in draw threads; release from any.
class RoadBuffers
{
public:
    static constexpr std::size_t kMostBytes = std::size_t{256}
                                              << 20; ///< of a context, but for what one draw needs

    explicit RoadBuffers(std::shared_ptr<const core::PagedRoadMesh> mesh);

    const core::PagedRoadMesh& mesh() const { return *_mesh; }
    /// Draws ranges of indices, which lie within one chunk each and grow.
    void draw(osg::State& state, std::span<const RoadRange> ranges);

    /// Returns the bytes that a context holds.
    std::size_t bytesOf(unsigned int contextId) const;

    /// Releases what a context has, or what all have.
    void releaseGLObjects(osg::State* state);

private:
    struct Pair
    {
        explicit Pair(unsigned int contextId) : vertices(contextId), indices(contextId) {}
        osgTraversal::ContextBuffer vertices, indices;
        std::uint64_t drawn = 0; ///< number of the draw that needed it last
    };

    /// What a context has; touched by its draw thread alone.
    struct Context
    {
        std::map<std::size_t, Pair> pairs; ///< by page
        std::uint64_t draws = 0;
        std::size_t bytes = 0;
    };

    Context& contextOf(osg::State& state);
    void bind(osg::State& state, Context& context, std::size_t page) const;
    void releaseOld(Context& context) const;

    std::shared_ptr<const core::PagedRoadMesh> _mesh;
    mutable std::mutex _mutex;
    std::map<unsigned int, std::unique_ptr<Context>> _contexts;
};

} // namespace osgRoads
