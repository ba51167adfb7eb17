// SPDX-License-Identifier: Apache-2.0
#include "QueueDriver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTerrainROAM::core
{

QueueDriver::QueueDriver(DiamondTree& tree, const viewlod::ViewState& view, double tolerancePx,
                         std::uint32_t maxLeaves, viewlod::Slice& slice, RefineResult& result)
    : _tree(tree),
      _view(view),
      _active(view, tolerancePx),
      _tolerancePx(tolerancePx),
      _maxLeaves(maxLeaves),
      _slice(slice),
      _result(result)
{
    for (const TriangleId root : DiamondTree::kRoots)
        if (_tree.canSplit(root)) _splits.push_back({priority(_tree.bound(root)), root});
    for (VertexSlot v = DiamondTree::kCorners; v < _tree.vertexSlots(); ++v)
    {
        if (_tree.place(v).isFree()) continue;
        for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
            if (const TriangleId t(v, quadrant); _tree.exists(t) && _tree.canSplit(t))
                _splits.push_back({priority(_tree.bound(t)), t});
        if (_tree.isMergeable(v)) _merges.push_back({priority(_tree.bound(v)), v});
    }
    std::make_heap(_splits.begin(), _splits.end());
    std::make_heap(_merges.begin(), _merges.end());
}

/// Computes the priority, on the side of the tolerance that the predicate decides, whatever the rounding of
/// the quotient.
double QueueDriver::priority(const SplitBound& bound)
{
    ++_result.checks;
    _slice.check();
    const double px = priorityPx(_view, bound);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return _active(bound) ? std::max(px, std::nextafter(_tolerancePx, kInfinity))
                          : std::min(px, _tolerancePx);
}

void QueueDriver::offer(TriangleId t)
{
    if (!_tree.exists(t) || !_tree.canSplit(t)) return;
    _splits.push_back({priority(_tree.bound(t)), t});
    std::push_heap(_splits.begin(), _splits.end());
}

void QueueDriver::offer(VertexSlot v)
{
    if (!_tree.isMergeable(v)) return;
    _merges.push_back({priority(_tree.bound(v)), v});
    std::push_heap(_merges.begin(), _merges.end());
}

const QueueDriver::Split* QueueDriver::nextSplit()
{
    while (!_splits.empty())
    {
        const TriangleId t = _splits.front().triangle;
        if (!_tree.place(t.apex()).isFree() && _tree.exists(t) && _tree.canSplit(t)) return &_splits.front();
        std::pop_heap(_splits.begin(), _splits.end());
        _splits.pop_back();
    }
    return nullptr;
}

const QueueDriver::Merge* QueueDriver::nextMerge()
{
    while (!_merges.empty())
    {
        if (_tree.isMergeable(_merges.front().vertex)) return &_merges.front();
        std::pop_heap(_merges.begin(), _merges.end());
        _merges.pop_back();
    }
    return nullptr;
}

void QueueDriver::split(TriangleId t)
{
    const std::size_t known = _tree.changes().vertices.size();
    const std::uint32_t splits = _tree.forceSplit(t);
    _result.splits += splits;
    _slice.change(splits);
    for (std::size_t i = known; i < _tree.changes().vertices.size(); ++i)
    {
        const VertexSlot v = _tree.changes().vertices[i];
        for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
            offer(TriangleId(v, quadrant));
        offer(v);
    }
}

void QueueDriver::merge(VertexSlot v)
{
    const auto parents = _tree.parents(v);
    _tree.merge(v);
    const unsigned merges = parents[1].exists() ? 2 : 1;
    _result.merges += merges;
    _slice.change(merges);
    for (const TriangleId t : parents)
    {
        if (!t.exists()) continue;
        offer(t);
        offer(t.apex());
    }
}

bool QueueDriver::refine()
{
    for (;;)
    {
        const Split* best = nextSplit();
        const Merge* worst = nextMerge();
        const double wanted = best ? best->priorityPx : 0.0;
        const double spared = worst ? worst->priorityPx : std::numeric_limits<double>::infinity();
        _result.tolerancePx =
            std::max(_tolerancePx, wanted * (wanted > _tolerancePx ? kPriorityRounding : 1.0));
        if (_slice.isSpent()) return false;
        if (spared <= _tolerancePx || _tree.leafCount() > _maxLeaves)
            merge(worst->vertex);
        else if (wanted <= _tolerancePx)
            return true;
        else if (_tree.hasRoomToSplit(best->triangle, _maxLeaves))
            split(best->triangle);
        else if (spared < wanted)
            merge(worst->vertex); // makes room
        else
            return true;
    }
}

} // namespace osgTerrainROAM::core
