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

/// The table of the leaves by their slots in the patches' vertex buffer. A leaf keeps its slot as long as it
/// exists, wherever its arena moves it: a patch is written once.
/// Invariant: after follow(), every drawn leaf of the tree has one slot, and no other triangle has any.
/// Memory: 16 B per vertex of the tree, 40 B per patch. Cost of following: proportional to the changes.
class PatchPool
{
public:
    /// Starts with the leaves of the tree. The tree has to record removed vertices (DiamondTree::noteGone()).
    explicit PatchPool(const DiamondTree& tree);

    /// Follows the changes of the tree. Call it before they are cleared.
    void follow(const DiamondTree& tree);

    /// Marks the patch of a leaf for rewriting after an edit of the tile. Call it after follow().
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

    /// Slots that the last follow() gave to other leaves, or that have to be rewritten.
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

    void assign(const DiamondTree& tree, TriangleId leaf);
    Patch boundOf(const RoamTile& tile, const GridTriangle& t) const;
    void release(TriangleId t);

    const PatchShape* _shape;
    std::vector<Slots> _slots;   ///< by vertex
    std::vector<Patch> _patches; ///< by slot
    std::vector<std::uint32_t> _freeSlots;
    std::vector<std::uint32_t> _written;
};

} // namespace osgTerrainROAM::core
