// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include <viewlod/Slice.h>

#include <osgTerrainROAM/core/roam/DiamondTree.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>

namespace osgTerrainROAM::core
{

/// How the walk removes a subtree.
enum class Removal
{
    atOnce,   ///< DiamondTree::enhMerge()
    oneByOne, ///< DiamondTree::forceMerge(), for comparison
};

/// Adapts a tree by a walk over all of it: splits or merges each triangle by its screen error.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), section 5.2 (the frame
/// loop).
/// Differs: the bounds nest in space, too (Refinement.h), so the result does not depend on the visiting
/// order.
template<class Active>
class WalkDriver
{
public:
    WalkDriver(DiamondTree& tree, const Active& active, std::uint32_t maxLeaves, viewlod::Slice& slice,
               RefineResult& result, Removal removal = Removal::atOnce)
        : _tree(tree),
          _active(active),
          _maxLeaves(maxLeaves),
          _slice(slice),
          _result(result),
          _removal(removal)
    {
    }

    /// Splits and merges until exactly the active vertices are split. Returns false when the slice was spent
    /// before, or when that takes more than `maxLeaves`: the mesh is valid then, too.
    bool refine()
    {
        // A split that does not fit at first may fit after the walk has merged later triangles.
        return (walkRoots() && !_leftOut) || (!_slice.isSpent() && walkRoots() && !_leftOut);
    }

private:
    bool walkRoots()
    {
        _leftOut = false;
        return std::all_of(std::begin(DiamondTree::kRoots), std::end(DiamondTree::kRoots),
                           [this](TriangleId root) { return walk(root); });
    }

    bool walk(TriangleId t)
    {
        if (_tree.isLeaf(t) && !_tree.canSplit(t)) return true;
        if (_slice.isSpent()) return false;
        ++_result.checks;
        _slice.check();
        const bool active = _active(_tree.bound(t));
        if (_tree.isLeaf(t))
        {
            if (!active) return true;
            if (!_tree.hasRoomToSplit(t, _maxLeaves))
            {
                _leftOut = true;
                return true;
            }
            count(_result.splits, _tree.forceSplit(t));
        }
        else if (!active)
        {
            const VertexSlot v = _tree.splitVertex(t);
            count(_result.merges, _removal == Removal::atOnce ? _tree.enhMerge(v) : _tree.forceMerge(v));
            return true;
        }
        const auto [first, second] = _tree.children(t);
        return walk(first) && walk(second);
    }

    void count(std::uint32_t& sum, std::uint32_t triangles)
    {
        sum += triangles;
        _slice.change(triangles);
    }

    DiamondTree& _tree;
    const Active& _active;
    std::uint32_t _maxLeaves;
    viewlod::Slice& _slice;
    RefineResult& _result;
    Removal _removal;
    bool _leftOut = false; ///< a split for want of room
};

} // namespace osgTerrainROAM::core
