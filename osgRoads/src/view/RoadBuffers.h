// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include <osg/State>

#include <osgRoads/core/surface/RoadMesh.h>

#include <osgTraversal/ContextBuffer>

namespace osgRoads
{

/// A range of a mesh's indices.
struct RoadRange
{
    std::uint32_t first = 0, count = 0;
};

/// The buffers of a road mesh in the graphics contexts. Each is filled when it is drawn first.
/// Threads: draw() in draw threads; release from any.
class RoadBuffers
{
public:
    explicit RoadBuffers(std::shared_ptr<const core::RoadMesh> mesh) : _mesh(std::move(mesh)) {}

    const core::RoadMesh& mesh() const { return *_mesh; }
    void draw(osg::State& state, const std::vector<RoadRange>& ranges);

    /// Releases what a context has, or what all have.
    void releaseGLObjects(osg::State* state);

private:
    struct Pair
    {
        explicit Pair(unsigned int contextId) : vertices(contextId), indices(contextId) {}
        osgTraversal::ContextBuffer vertices, indices;
    };

    Pair& pairOf(osg::State& state);

    std::shared_ptr<const core::RoadMesh> _mesh;
    std::mutex _mutex;
    std::map<unsigned int, std::unique_ptr<Pair>> _pairs;
};

} // namespace osgRoads
