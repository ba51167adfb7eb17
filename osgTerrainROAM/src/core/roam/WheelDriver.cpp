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

} // namespace

bool WheelDriver::refine(DiamondTree& tree, const viewlod::ViewState& view, double tolerancePx,
                         std::uint32_t maxLeaves, viewlod::Slice& slice, RefineResult& result)
{
    Frame frame{tree, ActiveForEye(view, tolerancePx), maxLeaves, slice, result};
    const double scale = view.guaranteedPixelsPerTangent() / tolerancePx;
    const double travelM = glm::distance(view.eyeWorld, _eye) + std::abs(view.nearM - _nearM);
    _followed = tree.changes().vertices.size();
    _wayM += travelM;
    bool leavingLeft = false;
    std::size_t comingLeft = 0;
    if (_knowsTree)
    {
        _wheel.advance(travelM, std::abs(scale - _scale), _due);
        // First what the last frame has left over, so that it is not left over for ever.
        change(frame, !_leaving.empty(), _coming.size());
        leavingLeft = !_leaving.empty();
        comingLeft = _coming.size();
        const std::vector<DeferralWheel::Handout> due = std::exchange(_due, {});
        lookAtAll(frame, due);
    }
    else
    {
        startOver(frame);
    }
    _eye = view.eyeWorld;
    _scale = scale;
    _nearM = view.nearM;
    return change(frame, leavingLeft, comingLeft) && _due.empty();
}

void WheelDriver::startOver(Frame& frame)
{
    _wheel.clear();
    _due.clear();
    _leaving.clear();
    _coming.clear();
    _marks.assign(frame.tree.vertexSlots(), {});
    _knowsTree = true;
    if (const TriangleId root = DiamondTree::kRoots[0]; frame.tree.isLeaf(root))
        look(frame, root.apex(), root.quadrant());
    for (VertexSlot v = DiamondTree::kCorners; v < frame.tree.vertexSlots(); ++v)
        if (!frame.tree.place(v).isFree()) follow(frame, v);
}

/// The work is waiting for memory; so it goes in small batches, of which all places are found before the first is looked
/// at. What the slice does not allow for stays due.
void WheelDriver::lookAtAll(Frame& frame, std::span<const DeferralWheel::Handout> due)
{
    constexpr std::size_t kBatch = 16;
    std::array<GridPoint, kBatch> places;
    std::array<DeferralWheel::Handout, kBatch> wanted;
    while (!due.empty() && !frame.slice.isSpent())
    {
        const auto batch = due.first(std::min(due.size(), kBatch));
        due = due.subspan(batch.size());
        for (const DeferralWheel::Handout& next : due.first(std::min(due.size(), kBatch)))
        {
            __builtin_prefetch(&_marks[next.watch >> 3]);
            __builtin_prefetch(&frame.tree.place(next.watch >> 3));
        }
        std::size_t count = 0;
        for (const DeferralWheel::Handout& handout : batch)
        {
            if (!isWanted(frame, handout)) continue;
            places[count] = watchedPlace(frame.tree, handout.watch >> 3, handout.watch & 7u);
            frame.tree.tile().prefetch(places[count]);
            wanted[count++] = handout;
        }
        for (std::size_t i = 0; i < count; ++i)
            if (isWanted(frame, wanted[i]))
                look(frame, wanted[i].watch >> 3, wanted[i].watch & 7u, places[i]);
    }
    for (const DeferralWheel::Handout& handout : due)
    {
        if (!isWanted(frame, handout)) continue;
        _marks[handout.watch >> 3][handout.watch & 7u] = kWaits;
        _due.push_back({handout.watch, kWaits});
    }
}

GridPoint WheelDriver::watchedPlace(const DiamondTree& tree, VertexSlot v, unsigned kind)
{
    return kind == kItself ? tree.place(v).point() : tree.middle(TriangleId(v, kind));
}

/// Whether anybody still waits for a watch that is handed out.
bool WheelDriver::isWanted(const Frame& frame, const DeferralWheel::Handout& handout) const
{
    const VertexSlot v = handout.watch >> 3;
    return _marks[v][handout.watch & 7u] == handout.mark && !frame.tree.place(v).isFree();
}

void WheelDriver::look(Frame& frame, VertexSlot v, unsigned kind)
{
    look(frame, v, kind, watchedPlace(frame.tree, v, kind));
}

void WheelDriver::look(Frame& frame, VertexSlot v, unsigned kind, GridPoint place)
{
    ++frame.result.checks;
    frame.slice.check();
    const SplitBound bound = frame.tree.tile().bound(place);
    const ActiveForEye::Verdict verdict = frame.active.verdict(bound);
    DeferralWheel::Mark& mark = _marks[v][kind];
    if (verdict.active == (kind == kItself))
    {
        const double marginM = std::max(verdict.marginM - kRoundingM, 0.0);
        mark = bound.errorM > 0.0f ? _wheel.add(watchOf(v, kind), bound.errorM, marginM) : kNotWatched;
        return;
    }
    mark = kWaits;
    if (kind == kItself)
        _leaving.push_back(v);
    else
        _coming.push_back({TriangleId(v, kind), bound.errorM, verdict.distanceM + _wayM});
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
    DiamondTree& tree = frame.tree;
    std::sort(_leaving.begin(), _leaving.end(),
              [&](VertexSlot a, VertexSlot b) { return tree.place(a).level > tree.place(b).level; });
    while (!_leaving.empty())
    {
        if (frame.slice.isSpent()) return false;
        const VertexSlot v = _leaving.back();
        _leaving.pop_back();
        if (tree.place(v).isFree() || _marks[v][kItself] != kWaits) continue;
        if (areStale && frame.active(tree.tile().bound(tree.place(v).point())))
        {
            look(frame, v, kItself); // came back
            continue;
        }
        const TriangleId parent = tree.parents(v)[0];
        const std::uint32_t merges = tree.enhMerge(v);
        frame.result.merges += merges;
        frame.slice.change(merges);
        look(frame, parent.apex(), parent.quadrant());
    }
    return true;
}

/// The first `stale` are of an earlier eye.
bool WheelDriver::letCome(Frame& frame, std::size_t stale)
{
    DiamondTree& tree = frame.tree;
    while (!_coming.empty())
    {
        if (frame.slice.isSpent()) return false;
        const TriangleId t = _coming.back().triangle;
        const bool isDone = tree.place(t.apex()).isFree() || _marks[t.apex()][t.quadrant()] != kWaits;
        const bool hasGone = !isDone && _coming.size() <= stale && !frame.active(tree.bound(t));
        if (!isDone && !hasGone && tree.leafCount() + tree.splitsNeeded(t) > frame.maxLeaves) return false;
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
    if (!_due.empty()) return std::numeric_limits<double>::infinity();
    double boundPx = tolerancePx;
    for (const Coming& coming : _coming)
        boundPx =
            std::max(boundPx, viewlod::screenErrorBoundPx(view.guaranteedPixelsPerTangent(), coming.errorM,
                                                          coming.nearestM - _wayM, 0.0, view.nearM));
    return boundPx;
}

std::size_t WheelDriver::memoryBytes() const
{
    return _wheel.memoryBytes() + _marks.capacity() * sizeof(_marks[0]) + _due.capacity() * sizeof(_due[0]) +
           _leaving.capacity() * sizeof(VertexSlot) + _coming.capacity() * sizeof(Coming);
}

} // namespace osgTerrainROAM::core
