// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <utility>

#include <osgTerrainROAM/core/roam/WheelDriver.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Exceeds the rounding error of a margin by far.
constexpr double kRoundingM = 1e-6;

constexpr std::uint32_t watchOf(VertexSlot v, unsigned kind)
{
    return v << 3 | kind;
}

constexpr VertexSlot vertexOf(std::uint32_t watch)
{
    return watch >> 3;
}

constexpr unsigned kindOf(std::uint32_t watch)
{
    return watch & 7u;
}

} // namespace

bool WheelDriver::refine(DiamondTree& tree, const viewlod::ViewState& view, double tolerancePx,
                         std::uint32_t maxLeaves, viewlod::Slice& slice, RefineResult& result)
{
    Frame frame{tree, ActiveInSight(view, tolerancePx, _sight), view.nearM, maxLeaves, slice, result};
    const double scale = view.guaranteedPixelsPerTangent() / tolerancePx;
    const double travelM = glm::distance(view.eyeWorld, _eye) + std::abs(view.nearM - _nearM);
    const bool isStill = _knowsTree && travelM == 0.0 && scale == _scale && !_sightMoved;
    // Moves the clocks, so that what has no margin is checked.
    const double turnM = _sight.isEverything() || isStill ? 0.0 : std::numeric_limits<double>::min();
    _sightMoved = false;
    if (isStill && _mergeCount == 0 && _splits.empty() && _rechecks.empty() && !_wheel.hasDue()) return true;
    _watched = tree.changes().vertices.size();
    _pathM += travelM;
    bool mergesLeft = false;
    std::size_t splitsLeft = 0;
    if (_knowsTree)
    {
        _wheel.advance(travelM + turnM, std::abs(scale - _scale));
        // First the work that the last frame left, so that it does not wait for ever.
        applyScheduled(frame, _mergeCount > 0, _splits.size());
        mergesLeft = _mergeCount > 0;
        splitsLeft = _splits.size();
        runRechecks(frame);
        checkDue(frame);
    }
    else
    {
        restart(frame);
    }
    _eye = view.eyeWorld;
    _scale = scale;
    _nearM = view.nearM;
    return applyScheduled(frame, mergesLeft, splitsLeft) && !_wheel.hasDue();
}

void WheelDriver::restart(Frame& frame)
{
    _rechecks.clear();
    _wheel.clear();
    _merges = {};
    _mergeCount = 0;
    _splits.clear();
    _backlog = {};
    _marks.assign(frame.tree.vertexSlots(), {});
    _knowsTree = true;
    if (const TriangleId root = DiamondTree::kRoots[0]; frame.tree.isLeaf(root))
        check(frame, root.apex(), root.quadrant());
    for (VertexSlot v = DiamondTree::kCorners; v < frame.tree.vertexSlots(); ++v)
        if (!frame.tree.place(v).isFree()) watchAround(frame, v);
}

/// Checks the points that recheck() was called for. A candidate that would split one leaf but not the coarser
/// leaf across its base is forgotten: splitting that leaf will watch it.
void WheelDriver::runRechecks(Frame& frame)
{
    const DiamondTree& tree = frame.tree;
    for (const GridPoint p : _rechecks)
    {
        const DiamondTree::AtPlace there = tree.atPlace(p);
        if (there.vertex != kNone) check(frame, there.vertex, kItself);
        for (std::size_t i = 0; i < there.leafCount; ++i)
            _marks[there.leaves[i].apex()][there.leaves[i].quadrant()] = kNotWatched;
        if (there.leafCount == 0) continue;
        const TriangleId t = there.leaves[0];
        const bool hasBoth = there.leafCount == 2 || !tree.acrossBase(t).exists();
        if (hasBoth) check(frame, t.apex(), t.quadrant());
    }
    _rechecks.clear();
}

inline GridPoint WheelDriver::watchedPoint(const DiamondTree& tree, VertexSlot v, unsigned kind)
{
    return kind == kItself ? tree.place(v).point() : tree.middle(TriangleId(v, kind));
}

/// Inlined into the loop over due watches: most of them only have to be watched further.
[[gnu::always_inline]] inline void WheelDriver::checkWatched(Frame& frame, std::uint32_t watch,
                                                             DeferralWheel::Mark& mark, GridPoint place)
{
    ++frame.result.checks;
    frame.slice.check();
    const SplitBound bound = frame.tree.bounds().bound(place);
    const ActiveForEye::Verdict verdict = frame.active.verdict(bound);
    if (verdict.active != (kindOf(watch) == kItself))
    {
        mark = kWaits;
        schedule(frame, watch, bound.errorM, verdict.distanceM);
        return;
    }
    mark = bound.errorM > 0.0f ? _wheel.add(watch, bound.errorM, verdict.marginM - kRoundingM) : kNotWatched;
}

/// Checks due watches in batches: memory is prefetched for one batch while the batch before is checked.
/// Watches that the slice does not allow for stay due.
void WheelDriver::checkDue(Frame& frame)
{
    std::array<DeferralWheel::Batch, 2> batches;
    for (std::size_t here = 0, there = 1;; std::swap(here, there))
    {
        DeferralWheel::Batch& next = batches[here];
        next.count = 0;
        if (!frame.slice.isSpent()) _wheel.nextDue(next);
        frame.slice.handOut(next.count);
        for (std::uint32_t i = 0; i < next.count; ++i)
        {
            __builtin_prefetch(&_marks[vertexOf(next.watches[i])]);
            __builtin_prefetch(&frame.tree.place(vertexOf(next.watches[i])));
        }
        checkBatch(frame, batches[there]);
        if (next.count == 0) return;
    }
}

/// Computes all points of the batch before it checks the first, so that their memory is prefetched.
void WheelDriver::checkBatch(Frame& frame, const DeferralWheel::Batch& batch)
{
    std::array<std::uint32_t, DeferralWheel::Batch::kMost> wanted; // places in the batch
    std::array<std::int32_t, DeferralWheel::Batch::kMost> columns, rows;
    const DiamondTree& tree = frame.tree;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < batch.count; ++i)
    {
        const VertexSlot v = vertexOf(batch.watches[i]);
        const unsigned kind = kindOf(batch.watches[i]);
        // Whether the watch is still wanted.
        if (_marks[v][kind] != batch.marks[i] || tree.place(v).isFree()) continue;
        const GridPoint place = watchedPoint(tree, v, kind);
        tree.bounds().prefetch(place);
        wanted[count] = i;
        columns[count] = place.column;
        rows[count++] = place.row;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::uint32_t watch = batch.watches[wanted[i]];
        DeferralWheel::Mark& mark = _marks[vertexOf(watch)][kindOf(watch)];
        if (mark == batch.marks[wanted[i]]) // and was not checked meanwhile
            checkWatched(frame, watch, mark, {columns[i], rows[i]});
    }
}

void WheelDriver::check(Frame& frame, VertexSlot v, unsigned kind)
{
    checkWatched(frame, watchOf(v, kind), _marks[v][kind], watchedPoint(frame.tree, v, kind));
}

/// Schedules a split or a merge: a vertex has become active, or is no longer.
void WheelDriver::schedule(Frame& frame, std::uint32_t watch, double errorM, double belowM)
{
    const VertexSlot v = vertexOf(watch);
    const unsigned kind = kindOf(watch);
    if (kind == kItself)
    {
        _merges[static_cast<std::size_t>(frame.tree.place(v).level)].push_back(v); // no corner: not negative
        ++_mergeCount;
        return;
    }
    if (_splits.empty()) _backlog = {.sinceM = _pathM};
    const double distanceM = std::max(belowM, frame.nearM);
    _backlog.errorPerM = std::max(_backlog.errorPerM, errorM / distanceM);
    _backlog.nearestM = std::min(_backlog.nearestM, distanceM);
    _splits.emplace_back(v, kind);
}

/// Watches a new vertex and the new candidates: the vertices on its diamond's edges that have both parents
/// now.
void WheelDriver::watchAround(Frame& frame, VertexSlot v)
{
    const DiamondTree& tree = frame.tree;
    check(frame, v, kItself);
    for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
    {
        const TriangleId t(v, quadrant);
        if (!tree.exists(t) || !tree.canSplit(t)) continue;
        const TriangleId across = tree.acrossBase(t);
        const bool hasBoth = !across.exists() || tree.level(across) == tree.level(t);
        const bool watchedThere = across.exists() && _marks[across.apex()][across.quadrant()] != kNotWatched;
        if (hasBoth && !watchedThere) check(frame, v, quadrant);
    }
}

void WheelDriver::watchNew(Frame& frame)
{
    const std::vector<VertexSlot>& added = frame.tree.changes().vertices;
    while (_marks.size() < frame.tree.vertexSlots())
        appendTightly(_marks);
    for (std::size_t i = _watched; i < added.size(); ++i)
    {
        _marks[added[i]] = {};
        for (const TriangleId t : frame.tree.parents(added[i]))
            if (t.exists()) _marks[t.apex()][t.quadrant()] = kNotWatched;
    }
    while (_watched < added.size())
        watchAround(frame, added[_watched++]);
}

/// Performs the scheduled merges and splits. Stale ones were found for an earlier eye and are checked once
/// more.
bool WheelDriver::applyScheduled(Frame& frame, bool staleMerges, std::size_t staleSplits)
{
    return mergeScheduled(frame, staleMerges) && splitScheduled(frame, staleSplits);
}

/// Merges coarser vertices first: each removes its subtree.
bool WheelDriver::mergeScheduled(Frame& frame, bool areStale)
{
    for (std::size_t level = 0; level < _merges.size() && _mergeCount > 0; ++level)
        while (!_merges[level].empty())
        {
            if (frame.slice.isSpent()) return false;
            const VertexSlot v = _merges[level].back();
            _merges[level].pop_back();
            --_mergeCount;
            if (!frame.tree.place(v).isFree() && _marks[v][kItself] == kWaits)
                mergeVertex(frame, v, areStale);
        }
    return true;
}

void WheelDriver::mergeVertex(Frame& frame, VertexSlot v, bool isStale)
{
    DiamondTree& tree = frame.tree;
    if (isStale && frame.active(tree.bound(v))) return check(frame, v, kItself); // active again
    const TriangleId parent = tree.parents(v)[0];
    const std::uint32_t merges = tree.enhMerge(v);
    frame.result.merges += merges;
    frame.slice.change(merges);
    check(frame, parent.apex(), parent.quadrant());
}

/// The first `stale` splits are of an earlier eye.
bool WheelDriver::splitScheduled(Frame& frame, std::size_t stale)
{
    DiamondTree& tree = frame.tree;
    while (!_splits.empty())
    {
        if (frame.slice.isSpent()) return false;
        const TriangleId t = _splits.back();
        const bool isDone = tree.place(t.apex()).isFree() || _marks[t.apex()][t.quadrant()] != kWaits;
        const bool hasGone = !isDone && _splits.size() <= stale && !frame.active(tree.bound(t));
        if (!isDone && !hasGone && !tree.hasRoomToSplit(t, frame.maxLeaves)) return false;
        _splits.pop_back();
        stale = std::min(stale, _splits.size());
        if (isDone) continue; // a forced split has done it
        if (hasGone)
        {
            check(frame, t.apex(), t.quadrant());
            continue;
        }
        const std::uint32_t splits = tree.forceSplit(t);
        frame.result.splits += splits;
        frame.slice.change(splits);
        watchNew(frame);
    }
    return true;
}

double WheelDriver::errorBoundPx(const viewlod::ViewState& view, double tolerancePx) const
{
    if (_wheel.hasDue()) return std::numeric_limits<double>::infinity();
    if (_splits.empty()) return tolerancePx;
    // Since then the eye may have come nearer by the growth of its path. d / max(d - nearer, near) is largest
    // for the nearest, or where the difference reaches the near distance.
    const double scale = view.guaranteedPixelsPerTangent(), nearerM = _pathM - _backlog.sinceM;
    const double atM = std::max(_backlog.nearestM, nearerM + view.nearM);
    return std::max(scale * _backlog.errorPerM * atM / (atM - nearerM), tolerancePx);
}

std::size_t WheelDriver::memoryBytes() const
{
    std::size_t bytes = _wheel.memoryBytes() + _marks.capacity() * sizeof(_marks[0]) +
                        _splits.capacity() * sizeof(TriangleId);
    for (const auto& ofLevel : _merges)
        bytes += ofLevel.capacity() * sizeof(VertexSlot);
    return bytes;
}

} // namespace osgTerrainROAM::core
