// SPDX-License-Identifier: Apache-2.0
// The paper's own frame loop (paper 1, §5.2): walk the tree of the last frame, split or merge by the screen error.
// Difference: the bounds nest in space, too (spec 1 D), so the result does not depend on the visiting order.
#include <algorithm>

#include <osgTerrainROAM/core/roam/Refinement.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/roam/TriangleCeiling.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Where the search for the ceiling's tolerance begins: somewhat below the last frame's, or far above the target.
constexpr double kWarmGuess = 0.97, kColdGuess = 64.0;

/// Splits and merges below `t` until exactly the active vertices are split. Stops early, returning false, when the
/// mesh outgrows `maxLeaves`: it is valid then, too.
template<class Active>
bool walk(BinTriangleTree& tree, NodeIndex t, const Active& active, std::uint32_t maxLeaves,
          RefineResult& result)
{
    if (tree.node(t).isLeaf())
    {
        if (!tree.canSplit(t) || !active(tree.node(t).bound)) return true;
        result.splits += tree.forceSplit(t);
        if (tree.leafCount() > maxLeaves) return false;
    }
    else if (!active(tree.node(t).bound))
    {
        result.merges += tree.enhMerge(t);
        return true;
    }
    const NodeIndex child = tree.node(t).firstChild;
    return walk(tree, child, active, maxLeaves, result) && walk(tree, child + 1, active, maxLeaves, result);
}

template<class Active>
bool walkRoots(BinTriangleTree& tree, const Active& active, std::uint32_t maxLeaves, RefineResult& result)
{
    return std::all_of(std::begin(BinTriangleTree::kRoots), std::end(BinTriangleTree::kRoots),
                       [&](NodeIndex root) { return walk(tree, root, active, maxLeaves, result); });
}

} // namespace

RoamMesh::RoamMesh(std::shared_ptr<const RoamTile> tile) : _tile(std::move(tile)), _tree(_tile) {}

RefineResult RoamMesh::refine(const viewlod::ViewState& view, const viewlod::Budget& budget)
{
    _tree.clearChanges();
    RefineResult result;
    result.tolerancePx = budget.errorTolerancePx;
    // A mesh that was at the ceiling is likely to be there again; else the search waits until it is needed.
    if (_ceilingBound)
        result.tolerancePx =
            toleranceWithinCeiling(*_tile, _tree, view, budget, kWarmGuess * _lastTolerancePx);
    constexpr auto kUnlimited = std::numeric_limits<std::uint32_t>::max();
    if (!walkRoots(_tree, ActiveForEye(view, result.tolerancePx),
                   _ceilingBound ? kUnlimited : budget.maxTriangles, result))
    {
        result.tolerancePx =
            toleranceWithinCeiling(*_tile, _tree, view, budget, kColdGuess * budget.errorTolerancePx);
        walkRoots(_tree, ActiveForEye(view, result.tolerancePx), kUnlimited, result);
    }
    _ceilingBound = result.ceilingBound = result.tolerancePx > budget.errorTolerancePx;
    _lastTolerancePx = result.tolerancePx;
    result.leaves = _tree.leafCount();
    result.triangles = _tree.leaves().leafCount();
    return result;
}

RefineResult RoamMesh::refine(double errorM)
{
    _tree.clearChanges();
    RefineResult result;
    walkRoots(_tree, ActiveForError{errorM}, std::numeric_limits<std::uint32_t>::max(), result);
    result.leaves = _tree.leafCount();
    result.triangles = _tree.leaves().leafCount();
    return result;
}

void RoamMesh::visibleRanges(const viewlod::Frustum& frustum, std::vector<TriangleRange>& ranges) const
{
    std::vector<std::uint32_t> regions;
    _tile->regions.visible(frustum, regions);
    const auto append = [&](std::uint32_t region)
    {
        const TriangleRange range = _tree.leaves().region(region);
        if (range.count > 0) ranges.push_back(range);
    };
    append(0); // leaves coarser than a region: few, and never worth a test
    for (const std::uint32_t path : regions)
        append(path + 1);
}

} // namespace osgTerrainROAM::core
