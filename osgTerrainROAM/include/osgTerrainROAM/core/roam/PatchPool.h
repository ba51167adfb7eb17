// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <viewlod/Frustum.h>

#include <osgTerrainROAM/core/roam/DiamondTree.h>
#include <osgTerrainROAM/core/roam/PatchShape.h>

namespace osgTerrainROAM::core
{

/// Which leaf has which slot of the patches' vertex buffer. A leaf keeps its slot as long as it lives, wherever its arena
/// moves it: a patch is written once.
/// Invariant: after follow(), every drawn leaf of the tree has one slot, and no other triangle has any.
/// Memory: 16 B per vertex of the tree, 40 B per patch. Cost of following: what has changed.
/// Source: terrain anchors, points 4 (stable slots) and 5 (chunked leaves).
class PatchPool
{
public:
    /// Starts with the leaves that the tree has. The tree has to note the vertices that go (DiamondTree::noteGone()).
    explicit PatchPool(const DiamondTree& tree);

    /// Takes over what the tree's changes say. To be called before they are cleared.
    void follow(const DiamondTree& tree);

    /// The patch of a leaf lies elsewhere: the tile has been edited. After follow().
    void rewrite(const DiamondTree& tree, TriangleId leaf);

    const PatchShape& shape() const { return *_shape; }

    std::uint32_t slotCount() const { return static_cast<std::uint32_t>(_patches.size()); }
    TriangleId leaf(std::uint32_t slot) const { return _patches[slot].leaf; } ///< none: the slot is free
    std::uint32_t slotOf(TriangleId leaf) const { return _slots[leaf.apex()][leaf.quadrant()]; }

    /// Of everything that the patch draws.
    const glm::dvec3& centre(std::uint32_t slot) const { return _patches[slot].centre; }
    bool mayBeSeen(std::uint32_t slot, const viewlod::Frustum& frustum) const
    {
        return !frustum.classify(_patches[slot].centre, _patches[slot].radiusM).outside;
    }

    /// Slots that the last follow() gave to other leaves, and that were rewritten.
    const std::vector<std::uint32_t>& written() const { return _written; }

    std::size_t memoryBytes() const;

private:
    struct Patch
    {
        TriangleId leaf;
        double radiusM = 0.0;
        glm::dvec3 centre{0.0};
    };
    using Slots = std::array<std::uint32_t, 4>; ///< of a vertex's quadrants
    static constexpr Slots kNoSlots = {kNone, kNone, kNone, kNone};

    void take(const DiamondTree& tree, TriangleId leaf);
    Patch boundOf(const RoamTile& tile, const GridTriangle& t) const;
    void release(TriangleId t);

    const PatchShape* _shape;
    std::vector<Slots> _slots;   ///< by vertex
    std::vector<Patch> _patches; ///< by slot
    std::vector<std::uint32_t> _freeSlots;
    std::vector<std::uint32_t> _written;
};

} // namespace osgTerrainROAM::core
