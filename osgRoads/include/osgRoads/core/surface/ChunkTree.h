// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgRoads/core/surface/RoadMesh.h>
#include <osgRoads/core/surface/RoadView.h>

namespace osgRoads::core
{

/// A binary tree of spheres around the chunks of a mesh, so that a view pays for the part of a network that
/// it sees. Differs from a library's R-tree: it is asked with a frustum and a distance at once, and a branch
/// that lies inside a plane is not tested against that plane again.
/// Memory: 12 B a chunk. Threads: const, any.
/// Source: Kay & Kajiya, *Ray tracing complex scenes*, 1986 (median cut); Assarsson & Möller, *Optimized View
/// Frustum Culling Algorithms for Bounding Boxes*, 2000 (planes that a branch need not be tested against).
class ChunkTree
{
public:
    /// The tree knows the chunks as they are now; it keeps no reference to the mesh.
    explicit ChunkTree(const RoadMesh& mesh);

    /// What a view sees.
    struct Visible
    {
        std::vector<std::uint32_t> chunks; ///< their numbers, growing
        std::size_t looks = 0;             ///< spheres, of branches and of chunks, that were looked at
    };

    /// Returns the chunks that touch the frustum, none farther from the eye than `farthestM`. Frame: `view`
    /// in the scene's.
    Visible visible(const viewlod::ViewState& view, double farthestM) const;

private:
    /// A branch: its items, and the sphere that holds theirs. An inner one is followed by its first half; the
    /// other half begins at `second`.
    struct Node
    {
        glm::dvec3 centre{0.0};
        double radius = 0.0;
        std::uint32_t first = 0, count = 0;
        std::uint32_t second = 0; ///< 0: a leaf
    };
    struct Sphere
    {
        glm::dvec3 centre{0.0};
        double radius = 0.0;
    };
    struct Search;

    static constexpr std::uint32_t kLeafItems = 8;

    void build(const std::vector<RoadChunk>& chunks, std::uint32_t first, std::uint32_t count);
    void search(std::uint32_t node, viewlod::Frustum::Mask toTest, Search& search) const;

    std::vector<Node> _nodes;
    std::vector<std::uint32_t> _items; ///< chunks
    std::vector<Sphere> _spheres;      ///< of _items
};

/// Chooses as chooseLevels(mesh, view, settings) does, and looks only at branches of the tree that the view
/// sees.
std::vector<ChunkChoice> chooseLevels(const RoadMesh& mesh, const ChunkTree& tree,
                                      const viewlod::ViewState& view, const RoadViewSettings& settings);

} // namespace osgRoads::core
