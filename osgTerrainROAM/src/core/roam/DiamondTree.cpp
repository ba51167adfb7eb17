// SPDX-License-Identifier: Apache-2.0
// Source: Duchaineau et al., *ROAMing Terrain*, 1997, section 4 (split, forced split, merge of diamonds).
// Differs: the vertices with their diamonds are stored, not the triangles. Two diamonds that share an edge
// belong to the same corner, in neighbouring quadrants, so a neighbour is found in two steps.
#include <algorithm>
#include <cassert>
#include <utility>

#include <osgTerrainROAM/core/roam/DiamondTree.h>
#include <osgTerrainROAM/core/roam/Outline.h>

namespace osgTerrainROAM::core
{

DiamondTree::DiamondTree(SplitBounds bounds, LeafPlacement placement)
    : DiamondLinks(bounds.tile().tile.grid().side() - 1),
      _bounds(std::move(bounds)),
      _levels(_bounds.levels()),
      _regionLevel(tile().regions.level()),
      _dataFillsTile(!tile().tile.samples().hasHoles() &&
                     std::min(tile().tile.grid().dataColumns(), tile().tile.grid().dataRows()) ==
                         tile().tile.grid().side()),
      _leaves(tile().regions.regionCount() + 1, placement)
{
    // The corners are stored as if they had split a larger triangle: the apexes of the two roots have one
    // quadrant each.
    const auto [first, second] = rootTriangles(tile().tile.grid().side());
    const GridPoint corners[kCorners] = {first.apex, second.apex, first.left, first.right};
    for (const GridPoint p : corners)
    {
        const VertexSlot slot = takeSlot();
        _places[slot] = {.column = static_cast<std::uint32_t>(p.column),
                         .row = static_cast<std::uint32_t>(p.row),
                         .direction = 0};
    }
    _places[0].direction = 2;
    _places[1].direction = 6;
    for (const TriangleId root : kRoots)
        addLeaf(root);
}

VertexSlot DiamondTree::takeSlot()
{
    VertexSlot slot;
    if (_freeSlots.empty())
    {
        slot = vertexSlots();
        appendTightly(_places);
        appendTightly(_diamonds);
    }
    else
    {
        slot = _freeSlots.back();
        _freeSlots.pop_back();
    }
    _changes.vertices.push_back(slot);
    return slot;
}

VertexSlot DiamondTree::addVertex(TriangleId t, TriangleId partner)
{
    const VertexSlot v = takeSlot(); // may move the pools: no reference is taken before
    const DiamondPlace& apex = _places[t.apex()];
    const GridPoint p = middle(t);
    DiamondPlace& place = _places[v];
    place.column = static_cast<std::uint32_t>(p.column) & 0x3fffffu;
    place.row = static_cast<std::uint32_t>(p.row) & 0x3fffffu;
    place.level = (apex.level + 1) & 0x7f;
    place.direction = (apex.direction + 2u * t.quadrant() + 5u) & 7u; // back to the apex
    place.firstQuadrant = t.quadrant() & 3u;
    place.secondQuadrant = partner.exists() ? partner.quadrant() & 3u : 0u;
    const std::uint32_t beyond = partner.exists() ? kUndrawn : kAbsent;
    _diamonds[v] = {{t.apex(), partner.exists() ? partner.apex() : kNone},
                    {kUndrawn, beyond, beyond, kUndrawn}};
    return v;
}

void DiamondTree::removeVertex(VertexSlot v)
{
    _places[v].direction |= DiamondPlace::kFree;
    _freeSlots.push_back(v);
    if (_notesGone) _changes.gone.push_back(v);
}

MeshVertex DiamondTree::vertex(VertexSlot v) const
{
    return meshVertex(position(v), _places[v].point(), tile().tile.frame().vertexStepM());
}

void DiamondTree::stopDisplacing()
{
    for (VertexSlot v = 0; v < _displacements.size(); ++v)
        if (_displacements[v] != glm::vec3(0.0f)) _changes.vertices.push_back(v);
    _displacements = {};
}

bool DiamondTree::isDrawn(TriangleId t) const
{
    return _dataFillsTile || core::isDrawn(tile().tile, gridTriangle(t));
}

/// Stores the slots that the arena has written in the links. A slot may have been written more than once, or
/// be unused now.
void DiamondTree::relink()
{
    for (; _linked < _changes.triangles.size(); ++_linked)
        if (const TriangleId t = _leaves.leaf(_changes.triangles[_linked]); t.exists())
            link(t) = _changes.triangles[_linked];
}

void DiamondTree::addLeaf(TriangleId t)
{
    ++_leafCount;
    if (!isDrawn(t))
    {
        link(t) = kUndrawn;
        ++_undrawnLeaves;
        return;
    }
    _leaves.insert(t, regionOf(t), _changes);
    relink();
}

/// Removes a leaf, given by the value of its link.
void DiamondTree::removeLeaf(std::uint32_t slot)
{
    --_leafCount;
    if (slot == kUndrawn)
    {
        --_undrawnLeaves;
        return;
    }
    _leaves.erase(slot, _changes);
    relink();
}

/// Splits `t` by `v`, whose two quadrants in it become leaves. Where it is drawn, they inherit its slot.
void DiamondTree::splitLeaf(TriangleId t, VertexSlot v)
{
    const std::uint32_t slot = link(t);
    link(t) = kSplit | v;
    auto [earlier, later] = children(t);
    if (isAgainstOrder(t)) std::swap(earlier, later);
    const bool isFirstDrawn = isDrawn(earlier), isLaterDrawn = isDrawn(later);
    const bool isInherited = slot != kUndrawn && level(t) >= _regionLevel && (isFirstDrawn || isLaterDrawn);
    if (!isInherited)
    {
        removeLeaf(slot);
        for (const TriangleId half : children(t))
            addLeaf(half);
        return;
    }
    ++_leafCount;
    if (isFirstDrawn && isLaterDrawn)
    {
        _leaves.split(slot, earlier, later, _changes);
        return relink();
    }
    link(isFirstDrawn ? later : earlier) = kUndrawn;
    ++_undrawnLeaves;
    inherit(slot, isFirstDrawn ? earlier : later);
}

/// Merges the halves of `t`, which are leaves. It inherits a slot of theirs.
void DiamondTree::mergeLeaves(TriangleId t)
{
    auto [kept, other] = children(t);
    if (link(kept) == kUndrawn) std::swap(kept, other);
    removeLeaf(link(other));
    const std::uint32_t slot = link(kept);
    if (slot != kUndrawn && level(t) >= _regionLevel && isDrawn(t)) return inherit(slot, t);
    removeLeaf(slot);
    addLeaf(t);
}

/// Gives the slot of one leaf to another of the same region.
void DiamondTree::inherit(std::uint32_t slot, TriangleId t)
{
    _leaves.replace(slot, t, _changes);
    relink();
}

std::uint32_t DiamondTree::forceSplit(TriangleId t)
{
    assert(canSplit(t));
    std::uint32_t splits = 0;
    TriangleId partner = acrossBase(t);
    if (partner.exists() && level(partner) < level(t))
    {
        splits += forceSplit(partner);
        partner = acrossBase(t);
    }
    const VertexSlot v = addVertex(t, partner);
    splitLeaf(t, v);
    if (!partner.exists()) return splits + 1;
    splitLeaf(partner, v);
    return splits + 2;
}

std::uint32_t DiamondTree::splitsNeeded(TriangleId t) const
{
    std::uint32_t splits = 0;
    for (TriangleId partner;; t = partner)
    {
        partner = acrossBase(t);
        splits += partner.exists() ? 2 : 1;
        if (!partner.exists() || level(partner) == level(t)) return splits;
    }
}

bool DiamondTree::isMergeable(VertexSlot v) const
{
    const auto& links = _diamonds[v].links;
    return v >= kCorners && !_places[v].isFree() &&
           std::none_of(std::begin(links), std::end(links),
                        [](std::uint32_t l) { return l >= kSplit && l != kAbsent; });
}

void DiamondTree::merge(VertexSlot v)
{
    assert(isMergeable(v));
    for (const TriangleId t : parents(v))
        if (t.exists()) mergeLeaves(t);
    removeVertex(v);
}

std::uint32_t DiamondTree::forceMerge(VertexSlot v)
{
    std::uint32_t merges = 0;
    for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
        if (const TriangleId t(v, quadrant); exists(t) && !isLeaf(t)) merges += forceMerge(splitVertex(t));
    const bool atBorder = !parents(v)[1].exists();
    merge(v);
    return merges + (atBorder ? 1u : 2u);
}

std::size_t DiamondTree::memoryBytes() const
{
    return _places.capacity() * sizeof(DiamondPlace) + _diamonds.capacity() * sizeof(Diamond) +
           _displacements.capacity() * sizeof(glm::vec3) + _freeSlots.capacity() * sizeof(VertexSlot) +
           _leaves.memoryBytes() +
           (_changes.vertices.capacity() + _changes.triangles.capacity() + _changes.gone.capacity()) *
               sizeof(std::uint32_t);
}

} // namespace osgTerrainROAM::core
