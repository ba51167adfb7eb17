// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgTerrainROAM/core/roam/PatchPool.h>

namespace osgTerrainROAM::core
{

PatchPool::PatchPool(const DiamondTree& tree) : _shape(&PatchShape::of(tree.bounds().patchExponent()))
{
    _slots.resize(tree.vertexSlots(), kNoSlots);
    for (std::uint32_t arenaSlot = 0; arenaSlot < tree.leaves().slotCount(); ++arenaSlot)
        if (const TriangleId t = tree.leaves().leaf(arenaSlot); t.exists()) assign(tree, t);
}

/// Releases slots first: of removed vertices, of vertices whose slot in the pool another vertex has taken
/// since, and of split triangles. Then a new leaf of the arena has no slot, and a leaf that only moved still
/// has its own.
void PatchPool::follow(const DiamondTree& tree)
{
    _written.clear();
    const MeshChanges& changes = tree.changes();
    _slots.resize(std::max<std::size_t>(_slots.size(), tree.vertexSlots()), kNoSlots);
    for (const auto* vertices : {&changes.gone, &changes.vertices})
        for (const VertexSlot v : *vertices)
            for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
                release({v, quadrant});
    for (const VertexSlot v : changes.vertices)
    {
        if (tree.place(v).isFree() || v < DiamondTree::kCorners) continue;
        for (const TriangleId t : tree.parents(v))
            if (t.exists()) release(t);
    }
    for (const std::uint32_t arenaSlot : changes.triangles)
        if (const TriangleId t = tree.leaves().leaf(arenaSlot); t.exists() && slotOf(t) == kNone)
            assign(tree, t);
}

void PatchPool::assign(const DiamondTree& tree, TriangleId leaf)
{
    std::uint32_t slot = slotCount();
    if (_freeSlots.empty())
    {
        appendTightly(_patches);
    }
    else
    {
        slot = _freeSlots.back();
        _freeSlots.pop_back();
    }
    _patches[slot] = boundOf(tree.tile(), tree.gridTriangle(leaf));
    _patches[slot].leaf = leaf;
    _slots[leaf.apex()][leaf.quadrant()] = slot;
    _written.push_back(slot);
}

void PatchPool::rewrite(const DiamondTree& tree, TriangleId leaf)
{
    const std::uint32_t slot = slotOf(leaf);
    if (slot == kNone) return;
    _patches[slot] = boundOf(tree.tile(), tree.gridTriangle(leaf));
    _patches[slot].leaf = leaf;
    _written.push_back(slot);
}

/// Bounds a patch: data samples of a triangle are within its error of the plane of the leaf without a patch.
/// Vertices beyond the data's edge may be farther.
PatchPool::Patch PatchPool::boundOf(const RoamTile& tile, const GridTriangle& t) const
{
    const auto position = [&](GridPoint p) { return tile.tile.position(p.column, p.row); };
    const glm::dvec3 left = position(t.left), right = position(t.right);
    Patch patch;
    patch.centre = 0.5 * (left + right);
    const auto isInData = [&](GridPoint p) { return tile.tile.grid().isInData(p.column, p.row); };
    if (isInData(t.apex) && isInData(t.left) && isInData(t.right))
    {
        const double cornersM =
            std::max(glm::distance(patch.centre, position(t.apex)), glm::distance(patch.centre, left));
        patch.radiusM = cornersM + tile.bound(t.middleOfBase()).errorM;
        return patch;
    }
    for (const PatchShape::Place place : _shape->vertices)
        patch.radiusM =
            std::max(patch.radiusM, glm::distance(patch.centre, position(_shape->gridPoint(t, place))));
    return patch;
}

void PatchPool::release(TriangleId t)
{
    std::uint32_t& slot = _slots[t.apex()][t.quadrant()];
    if (slot == kNone) return;
    _patches[slot].leaf = {};
    _freeSlots.push_back(slot);
    slot = kNone;
}

std::size_t PatchPool::memoryBytes() const
{
    return _slots.capacity() * sizeof(Slots) + _patches.capacity() * sizeof(Patch) +
           (_freeSlots.capacity() + _written.capacity()) * sizeof(std::uint32_t);
}

} // namespace osgTerrainROAM::core
