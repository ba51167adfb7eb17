// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <osgTerrainROAM/core/roam/QueueDriver.h>

namespace osgTerrainROAM::core
{

bool QueueDriver::isPossible(const DiamondTree& tree, const Split& split)
{
    const TriangleId t = split.triangle;
    return !tree.place(t.apex()).isFree() && tree.exists(t) && tree.canSplit(t) &&
           tree.middle(t) == split.place;
}

bool QueueDriver::isPossible(const DiamondTree& tree, const Merge& merge)
{
    return tree.isMergeable(merge.vertex) && tree.place(merge.vertex).point() == merge.place;
}

/// Computes the priority, on the side of the tolerance that the predicate decides, whatever the rounding of
/// the quotient.
double QueueDriver::priority(Frame& frame, const SplitBound& bound)
{
    ++frame.result.checks;
    frame.slice.check();
    if (!frame.sight.touches(glm::dvec3(bound.centre), bound.radiusM)) return 0.0;
    const double px = priorityPx(frame.view, bound);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return frame.active(bound) ? std::max(px, std::nextafter(frame.tolerancePx, kInfinity))
                               : std::min(px, frame.tolerancePx);
}

/// Marks as queued. Returns false where it was before.
bool QueueDriver::claim(VertexSlot v, unsigned kind)
{
    const auto bit = static_cast<std::uint8_t>(1u << kind);
    if (_queued[v] & bit) return false;
    _queued[v] |= bit;
    return true;
}

/// Fills the queues from a tree that is not known.
void QueueDriver::fill(Frame& frame)
{
    const DiamondTree& tree = frame.tree;
    _splits.clear();
    _merges.clear();
    _queued.assign(tree.vertexSlots(), 0);
    for (const TriangleId root : DiamondTree::kRoots)
        offer(frame, root);
    for (VertexSlot v = DiamondTree::kCorners; v < tree.vertexSlots(); ++v)
    {
        if (tree.place(v).isFree()) continue;
        for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
            offer(frame, TriangleId(v, quadrant));
        offer(frame, v);
    }
    _knowsTree = true;
}

/// Computes the priorities of all that is queued, and leaves out what is not possible any more.
void QueueDriver::computeAnew(Frame& frame)
{
    const DiamondTree& tree = frame.tree;
    std::fill(_queued.begin(), _queued.end(), std::uint8_t{0});
    std::erase_if(_splits,
                  [&](Split& split)
                  {
                      if (!isPossible(tree, split) ||
                          !claim(split.triangle.apex(), split.triangle.quadrant()))
                          return true;
                      split.priorityPx = priority(frame, tree.bound(split.triangle));
                      return false;
                  });
    std::erase_if(_merges,
                  [&](Merge& merge)
                  {
                      if (!isPossible(tree, merge) || !claim(merge.vertex, kItself)) return true;
                      merge.priorityPx = priority(frame, tree.bound(merge.vertex));
                      return false;
                  });
    std::make_heap(_splits.begin(), _splits.end());
    std::make_heap(_merges.begin(), _merges.end());
}

void QueueDriver::offer(Frame& frame, TriangleId t)
{
    const DiamondTree& tree = frame.tree;
    if (!tree.exists(t) || !tree.canSplit(t) || !claim(t.apex(), t.quadrant())) return;
    _splits.push_back({priority(frame, tree.bound(t)), t, tree.middle(t)});
    std::push_heap(_splits.begin(), _splits.end());
}

void QueueDriver::offer(Frame& frame, VertexSlot v)
{
    const DiamondTree& tree = frame.tree;
    if (!tree.isMergeable(v) || !claim(v, kItself)) return;
    _merges.push_back({priority(frame, tree.bound(v)), v, tree.place(v).point()});
    std::push_heap(_merges.begin(), _merges.end());
}

/// The mark of what is thrown away goes, too, unless another vertex has the slot now: then it belongs to it.
const QueueDriver::Split* QueueDriver::nextSplit(const DiamondTree& tree)
{
    while (!_splits.empty() && !isPossible(tree, _splits.front()))
    {
        const TriangleId t = _splits.front().triangle;
        if (!tree.place(t.apex()).isFree() && tree.exists(t) && tree.middle(t) == _splits.front().place)
            _queued[t.apex()] &= static_cast<std::uint8_t>(~(1u << t.quadrant()));
        std::pop_heap(_splits.begin(), _splits.end());
        _splits.pop_back();
    }
    return _splits.empty() ? nullptr : &_splits.front();
}

const QueueDriver::Merge* QueueDriver::nextMerge(const DiamondTree& tree)
{
    while (!_merges.empty() && !isPossible(tree, _merges.front()))
    {
        const Merge& gone = _merges.front();
        if (!tree.place(gone.vertex).isFree() && tree.place(gone.vertex).point() == gone.place)
            _queued[gone.vertex] &= static_cast<std::uint8_t>(~(1u << kItself));
        std::pop_heap(_merges.begin(), _merges.end());
        _merges.pop_back();
    }
    return _merges.empty() ? nullptr : &_merges.front();
}

void QueueDriver::split(Frame& frame, TriangleId t)
{
    DiamondTree& tree = frame.tree;
    const std::size_t known = tree.changes().vertices.size();
    const std::uint32_t splits = tree.forceSplit(t);
    frame.result.splits += splits;
    frame.slice.change(splits);
    _queued.resize(tree.vertexSlots(), 0);
    const std::vector<VertexSlot>& added = tree.changes().vertices;
    for (std::size_t i = known; i < added.size(); ++i)
        _queued[added[i]] = 0; // marks of a vertex that had the slot before
    for (std::size_t i = known; i < added.size(); ++i)
    {
        for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
            offer(frame, TriangleId(added[i], quadrant));
        offer(frame, added[i]);
    }
}

void QueueDriver::merge(Frame& frame, VertexSlot v)
{
    DiamondTree& tree = frame.tree;
    const auto parents = tree.parents(v);
    tree.merge(v);
    const unsigned merges = parents[1].exists() ? 2 : 1;
    frame.result.merges += merges;
    frame.slice.change(merges);
    for (const TriangleId t : parents)
    {
        if (!t.exists()) continue;
        offer(frame, t);
        offer(frame, t.apex());
    }
}

bool QueueDriver::refine(DiamondTree& tree, const viewlod::ViewState& view, const viewlod::Sight& sight,
                         const viewlod::Budget& ofLeaves, viewlod::Slice& slice, RefineResult& result)
{
    const double tolerancePx = ofLeaves.errorTolerancePx;
    Frame frame{tree, view, sight, ActiveForEye(view, tolerancePx), tolerancePx, slice, result};
    Seen seen{view.eyeWorld, view.guaranteedPixelsPerTangent(), view.nearM, tolerancePx, sight};
    if (!_knowsTree)
        fill(frame);
    else if (!_isFresh || seen != _seen)
        computeAnew(frame);
    _seen = std::move(seen);
    _isFresh = true;
    for (;;)
    {
        const Split* best = nextSplit(tree);
        const Merge* worst = nextMerge(tree);
        const double wanted = best ? best->priorityPx : 0.0;
        const double spared = worst ? worst->priorityPx : std::numeric_limits<double>::infinity();
        result.tolerancePx = std::max(tolerancePx, wanted * (wanted > tolerancePx ? kPriorityRounding : 1.0));
        if (slice.isSpent()) return false;
        const bool mustMerge = spared <= tolerancePx || tree.leafCount() > ofLeaves.maxTriangles;
        const bool isWanted = !mustMerge && wanted > tolerancePx;
        if (isWanted && tree.hasRoomToSplit(best->triangle, ofLeaves.maxTriangles))
            split(frame, best->triangle);
        else if (mustMerge || (isWanted && spared < wanted)) // the latter makes room
            merge(frame, worst->vertex);
        else
            return true;
    }
}

std::size_t QueueDriver::memoryBytes() const
{
    return _splits.capacity() * sizeof(Split) + _merges.capacity() * sizeof(Merge) + _queued.capacity();
}

} // namespace osgTerrainROAM::core
