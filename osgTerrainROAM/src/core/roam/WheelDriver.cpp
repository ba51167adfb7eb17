// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <utility>

#include <osgTerrainROAM/core/roam/WheelDriver.h>

namespace osgTerrainROAM::core
{

namespace
{

/// What rounding can add to a margin, and far more.
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
    Frame frame{tree, ActiveForEye(view, tolerancePx), view.nearM, maxLeaves, slice, result};
    const double scale = view.guaranteedPixelsPerTangent() / tolerancePx;
    const double travelM = glm::distance(view.eyeWorld, _eye) + std::abs(view.nearM - _nearM);
    const bool isStill = _knowsTree && travelM == 0.0 && scale == _scale;
    if (isStill && _leavingCount == 0 && _coming.empty() && _again.empty() && !_wheel.hasDue()) return true;
    _followed = tree.changes().vertices.size();
    _wayM += travelM;
    bool leavingLeft = false;
    std::size_t comingLeft = 0;
    if (_knowsTree)
    {
        _wheel.advance(travelM, std::abs(scale - _scale));
        // First what the last frame has left over, so that it is not left over for ever.
        change(frame, _leavingCount > 0, _coming.size());
        leavingLeft = _leavingCount > 0;
        comingLeft = _coming.size();
        lookAgain(frame);
        lookAtDue(frame);
    }
    else
    {
        startOver(frame);
    }
    _eye = view.eyeWorld;
    _scale = scale;
    _nearM = view.nearM;
    return change(frame, leavingLeft, comingLeft) && !_wheel.hasDue();
}

void WheelDriver::startOver(Frame& frame)
{
    _again.clear();
    _wheel.clear();
    _leaving = {};
    _leavingCount = 0;
    _coming.clear();
    _backlog = {};
    _marks.assign(frame.tree.vertexSlots(), {});
    _knowsTree = true;
    if (const TriangleId root = DiamondTree::kRoots[0]; frame.tree.isLeaf(root))
        look(frame, root.apex(), root.quadrant());
    for (VertexSlot v = DiamondTree::kCorners; v < frame.tree.vertexSlots(); ++v)
        if (!frame.tree.place(v).isFree()) follow(frame, v);
}

/// Whatever was known of those places is not true any more. What would split one leaf only, and not the coarser one across,
/// is forgotten: who splits that one looks.
void WheelDriver::lookAgain(Frame& frame)
{
    const DiamondTree& tree = frame.tree;
    for (const GridPoint p : _again)
    {
        const DiamondTree::AtPlace there = tree.atPlace(p);
        if (there.vertex != kNone) look(frame, there.vertex, kItself);
        for (std::size_t i = 0; i < there.leafCount; ++i)
            _marks[there.leaves[i].apex()][there.leaves[i].quadrant()] = kNotWatched;
        if (there.leafCount == 0) continue;
        const TriangleId t = there.leaves[0];
        const bool hasBoth = there.leafCount == 2 || !tree.acrossBase(t).exists();
        if (hasBoth) look(frame, t.apex(), t.quadrant());
    }
    _again.clear();
}

inline GridPoint WheelDriver::watchedPlace(const DiamondTree& tree, VertexSlot v, unsigned kind)
{
    return kind == kItself ? tree.place(v).point() : tree.middle(TriangleId(v, kind));
}

/// Compiled into the loop over what is due: most of that only has to be watched further.
[[gnu::always_inline]] inline void WheelDriver::lookAt(Frame& frame, std::uint32_t watch,
                                                       DeferralWheel::Mark& mark, GridPoint place)
{
    ++frame.result.checks;
    frame.slice.check();
    const SplitBound bound = frame.tree.bounds().bound(place);
    const ActiveForEye::Verdict verdict = frame.active.verdict(bound);
    if (verdict.active != (kindOf(watch) == kItself))
    {
        mark = kWaits;
        found(frame, watch, bound.errorM, verdict.distanceM);
        return;
    }
    mark = bound.errorM > 0.0f ? _wheel.add(watch, bound.errorM, verdict.marginM - kRoundingM) : kNotWatched;
}

/// The work is waiting for memory; so it goes in batches, and each is announced while the one before is looked at. What the
/// slice does not allow for stays due.
void WheelDriver::lookAtDue(Frame& frame)
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
        lookAtBatch(frame, batches[there]);
        if (next.count == 0) return;
    }
}

/// All places are found before the first is looked at.
void WheelDriver::lookAtBatch(Frame& frame, const DeferralWheel::Batch& batch)
{
    std::array<std::uint32_t, DeferralWheel::Batch::kMost> wanted; // places in the batch
    std::array<std::int32_t, DeferralWheel::Batch::kMost> columns, rows;
    const DiamondTree& tree = frame.tree;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < batch.count; ++i)
    {
        const VertexSlot v = vertexOf(batch.watches[i]);
        const unsigned kind = kindOf(batch.watches[i]);
        // Whether anybody still waits for it.
        if (_marks[v][kind] != batch.marks[i] || tree.place(v).isFree()) continue;
        const GridPoint place = watchedPlace(tree, v, kind);
        tree.bounds().prefetch(place);
        wanted[count] = i;
        columns[count] = place.column;
        rows[count++] = place.row;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::uint32_t watch = batch.watches[wanted[i]];
        DeferralWheel::Mark& mark = _marks[vertexOf(watch)][kindOf(watch)];
        if (mark == batch.marks[wanted[i]]) // and has not just been looked at
            lookAt(frame, watch, mark, {columns[i], rows[i]});
    }
}

void WheelDriver::look(Frame& frame, VertexSlot v, unsigned kind)
{
    lookAt(frame, watchOf(v, kind), _marks[v][kind], watchedPlace(frame.tree, v, kind));
}

/// A vertex has become active, or is no longer.
void WheelDriver::found(Frame& frame, std::uint32_t watch, double errorM, double belowM)
{
    const VertexSlot v = vertexOf(watch);
    const unsigned kind = kindOf(watch);
    if (kind == kItself)
    {
        _leaving[static_cast<std::size_t>(frame.tree.place(v).level)].push_back(v); // no corner: not negative
        ++_leavingCount;
        return;
    }
    if (_coming.empty()) _backlog = {.sinceM = _wayM};
    const double distanceM = std::max(belowM, frame.nearM);
    _backlog.errorPerM = std::max(_backlog.errorPerM, errorM / distanceM);
    _backlog.nearestM = std::min(_backlog.nearestM, distanceM);
    _coming.emplace_back(v, kind);
}

/// Watches a new vertex, and what could come after it: the vertices on its diamond's edges that have both parents now.
void WheelDriver::follow(Frame& frame, VertexSlot v)
{
    const DiamondTree& tree = frame.tree;
    look(frame, v, kItself);
    for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
    {
        const TriangleId t(v, quadrant);
        if (!tree.exists(t) || !tree.canSplit(t)) continue;
        const TriangleId across = tree.acrossBase(t);
        const bool hasBoth = !across.exists() || tree.level(across) == tree.level(t);
        const bool watchedThere = across.exists() && _marks[across.apex()][across.quadrant()] != kNotWatched;
        if (hasBoth && !watchedThere) look(frame, v, quadrant);
    }
}

void WheelDriver::followNew(Frame& frame)
{
    const std::vector<VertexSlot>& added = frame.tree.changes().vertices;
    while (_marks.size() < frame.tree.vertexSlots())
        appendTightly(_marks);
    for (std::size_t i = _followed; i < added.size(); ++i)
    {
        _marks[added[i]] = {};
        for (const TriangleId t : frame.tree.parents(added[i]))
            if (t.exists()) _marks[t.apex()][t.quadrant()] = kNotWatched;
    }
    while (_followed < added.size())
        follow(frame, added[_followed++]);
}

/// Does what has been found to do. Stale is what was found for an earlier eye: it has to be looked at once more.
bool WheelDriver::change(Frame& frame, bool staleLeaving, std::size_t staleComing)
{
    return letGo(frame, staleLeaving) && letCome(frame, staleComing);
}

/// Coarser vertices first: what stands on them goes along.
bool WheelDriver::letGo(Frame& frame, bool areStale)
{
    for (std::size_t level = 0; level < _leaving.size() && _leavingCount > 0; ++level)
        while (!_leaving[level].empty())
        {
            if (frame.slice.isSpent()) return false;
            const VertexSlot v = _leaving[level].back();
            _leaving[level].pop_back();
            --_leavingCount;
            if (!frame.tree.place(v).isFree() && _marks[v][kItself] == kWaits) takeOut(frame, v, areStale);
        }
    return true;
}

void WheelDriver::takeOut(Frame& frame, VertexSlot v, bool isStale)
{
    DiamondTree& tree = frame.tree;
    if (isStale && frame.active(tree.bound(v))) return look(frame, v, kItself); // came back
    const TriangleId parent = tree.parents(v)[0];
    const std::uint32_t merges = tree.enhMerge(v);
    frame.result.merges += merges;
    frame.slice.change(merges);
    look(frame, parent.apex(), parent.quadrant());
}

/// The first `stale` are of an earlier eye.
bool WheelDriver::letCome(Frame& frame, std::size_t stale)
{
    DiamondTree& tree = frame.tree;
    while (!_coming.empty())
    {
        if (frame.slice.isSpent()) return false;
        const TriangleId t = _coming.back();
        const bool isDone = tree.place(t.apex()).isFree() || _marks[t.apex()][t.quadrant()] != kWaits;
        const bool hasGone = !isDone && _coming.size() <= stale && !frame.active(tree.bound(t));
        if (!isDone && !hasGone && !tree.hasRoomToSplit(t, frame.maxLeaves)) return false;
        _coming.pop_back();
        stale = std::min(stale, _coming.size());
        if (isDone) continue; // a forced split was first
        if (hasGone)
        {
            look(frame, t.apex(), t.quadrant());
            continue;
        }
        const std::uint32_t splits = tree.forceSplit(t);
        frame.result.splits += splits;
        frame.slice.change(splits);
        followNew(frame);
    }
    return true;
}

double WheelDriver::errorBoundPx(const viewlod::ViewState& view, double tolerancePx) const
{
    if (_wheel.hasDue()) return std::numeric_limits<double>::infinity();
    if (_coming.empty()) return tolerancePx;
    // Since then the eye may have come nearer, by as much as its way has grown. d / max(d - nearer, near) is largest for
    // the nearest, or where the difference reaches the near distance.
    const double scale = view.guaranteedPixelsPerTangent(), nearerM = _wayM - _backlog.sinceM;
    const double atM = std::max(_backlog.nearestM, nearerM + view.nearM);
    return std::max(scale * _backlog.errorPerM * atM / (atM - nearerM), tolerancePx);
}

std::size_t WheelDriver::memoryBytes() const
{
    std::size_t bytes = _wheel.memoryBytes() + _marks.capacity() * sizeof(_marks[0]) +
                        _coming.capacity() * sizeof(TriangleId);
    for (const auto& ofLevel : _leaving)
        bytes += ofLevel.capacity() * sizeof(VertexSlot);
    return bytes;
}

} // namespace osgTerrainROAM::core
