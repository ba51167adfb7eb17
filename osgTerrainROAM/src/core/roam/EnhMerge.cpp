// SPDX-License-Identifier: Apache-2.0
// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), section 5.2 (enhMerge).
// Differs: the paper descends from neighbour to neighbour. Among diamonds the removed vertices are simply all
// descendants: a vertex is removed when one of its two parents is. The new leaves are found afterwards:
// triangles that were split by a removed vertex with one remaining parent.
#include <cassert>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace osgTerrainROAM::core
{

std::uint32_t DiamondTree::enhMerge(VertexSlot v)
{
    assert(v >= kCorners && !_places[v].isFree());
    const std::size_t first = _freeSlots.size();
    std::uint32_t merges = 0;
    removeVertex(v);
    for (std::size_t next = first; next < _freeSlots.size(); ++next)
    {
        constexpr std::size_t kAhead = 8;
        if (next + kAhead < _freeSlots.size()) __builtin_prefetch(&_diamonds[_freeSlots[next + kAhead]]);
        merges += takeApart(_freeSlots[next]);
    }
    // A new leaf takes the slot of a leaf that was below it; leaves coarser than a region take any slot,
    // after the others.
    const auto forEachNewLeaf = [&](auto add)
    {
        for (std::size_t i = first; i < _freeSlots.size(); ++i)
        {
            const VertexSlot gone = _freeSlots[i];
            if (_places[gone].direction & DiamondPlace::kLostBoth) continue;
            for (const TriangleId t : parents(gone))
                if (t.exists() && !_places[t.apex()].isFree()) add(t);
        }
    };
    bool isAnyLeft = false;
    forEachNewLeaf(
        [&](TriangleId t)
        {
            const std::uint32_t gap = level(t) < _regionLevel || !isDrawn(t) ? kUndrawn : cutBelow(t);
            if (gap == kUndrawn)
            {
                isAnyLeft = true;
                return;
            }
            _leaves.fillGap(link(t) = gap, t);
            ++_leafCount;
        });
    _leaves.closeGaps(_changes);
    relink();
    if (!isAnyLeft) return merges;
    forEachNewLeaf(
        [&](TriangleId t)
        {
            if (!isLeaf(t)) addLeaf(t);
        });
    return merges;
}

/// Cuts the leaves around a vertex out of the arena, and removes its child vertices. Returns the number of
/// triangles that it had split.
std::uint32_t DiamondTree::takeApart(VertexSlot v)
{
    bool atBorder = false;
    for (const std::uint32_t here : _diamonds[v].links)
    {
        if (here == kAbsent)
        {
            atBorder = true;
        }
        else if (here >= kSplit)
        {
            const VertexSlot below = here & ~kSplit;
            if (_places[below].isFree())
                _places[below].direction |= DiamondPlace::kLostBoth;
            else
                removeVertex(below);
        }
        else
        {
            --_leafCount;
            if (here == kUndrawn)
                --_undrawnLeaves;
            else
                _leaves.cutOut(here);
        }
    }
    return atBorder ? 1 : 2;
}

/// Returns the slot of a leaf that was cut out below a triangle; kUndrawn where none below was drawn.
std::uint32_t DiamondTree::cutBelow(TriangleId t) const
{
    const std::uint32_t here = link(t);
    if (here < kSplit) return here;
    const auto halves = children(t);
    const std::uint32_t slot = cutBelow(halves[0]);
    return slot != kUndrawn ? slot : cutBelow(halves[1]);
}

} // namespace osgTerrainROAM::core
