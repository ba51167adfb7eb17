// SPDX-License-Identifier: Apache-2.0
// enhMerge, paper 1, §5.2. What the paper finds by descending from neighbour to neighbour is, among the diamonds, simply
// everything below: a vertex goes when one of the two that it hangs on goes. The boundary shows afterwards: vertices that
// went and hang, with one hand, on one that stays.
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
    // What becomes a leaf takes the place of one that was below it, and, coarser than a region, any, once that is empty.
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

/// Cuts the leaves around a vertex out of what is drawn, and frees the vertices that hang on it. Returns the number of
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

/// The slot of a leaf that was cut out below a triangle; kUndrawn where none below was drawn.
std::uint32_t DiamondTree::cutBelow(TriangleId t) const
{
    const std::uint32_t here = link(t);
    if (here < kSplit) return here;
    const auto halves = children(t);
    const std::uint32_t slot = cutBelow(halves[0]);
    return slot != kUndrawn ? slot : cutBelow(halves[1]);
}

} // namespace osgTerrainROAM::core
