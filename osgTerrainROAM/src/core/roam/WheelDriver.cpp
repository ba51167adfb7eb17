// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
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
    _followed = tree.changes().vertices.size();
    if (_knowsTree)
    {
        lookAtRest(frame);
        _wheel.advance(glm::distance(view.eyeWorld, _eye) + std::abs(view.nearM - _nearM),
                       std::abs(scale - _scale),
                       [&](std::span<const DeferralWheel::Handout> due) { lookAtDue(frame, due); });
    }
    else
    {
        startOver(frame);
    }
    _eye = view.eyeWorld;
    _scale = scale;
    _nearM = view.nearM;
    const bool finished = letGo(frame) && letCome(frame);
    return finished && _waiting.empty();
}

void WheelDriver::startOver(Frame& frame)
{
    _wheel.clear();
    _waiting.clear();
    _leaving.clear();
    _coming.clear();
    _marks.assign(frame.tree.vertexSlots(), {});
    _knowsTree = true;
    look(frame, DiamondTree::kRoots[0].apex(), DiamondTree::kRoots[0].quadrant());
    for (VertexSlot v = DiamondTree::kCorners; v < frame.tree.vertexSlots(); ++v)
        if (!frame.tree.place(v).isFree()) follow(frame, v);
}

/// What the last frame has left over.
void WheelDriver::lookAtRest(Frame& frame)
{
    for (const VertexSlot v : _leaving)
        _waiting.push_back(watchOf(v, kItself));
    for (const TriangleId t : _coming)
        _waiting.push_back(watchOf(t.apex(), t.quadrant()));
    _leaving.clear();
    _coming.clear();
    for (const std::uint32_t watch : std::exchange(_waiting, {}))
        lookAgain(frame, watch, kWaits);
}

/// The work is waiting for memory; so each watch announces those that come later.
void WheelDriver::lookAtDue(Frame& frame, std::span<const DeferralWheel::Handout> due)
{
    constexpr std::size_t kPlaceAhead = 16, kSampleAhead = 8;
    for (std::size_t i = 0; i < due.size(); ++i)
    {
        if (i + kPlaceAhead < due.size())
        {
            const VertexSlot v = due[i + kPlaceAhead].watch >> 3;
            __builtin_prefetch(&_marks[v]);
            __builtin_prefetch(&frame.tree.place(v));
        }
        if (i + kSampleAhead < due.size())
        {
            const std::uint32_t watch = due[i + kSampleAhead].watch;
            frame.tree.tile().prefetch(watchedPlace(frame.tree, watch >> 3, watch & 7u));
        }
        lookAgain(frame, due[i].watch, due[i].mark);
    }
}

GridPoint WheelDriver::watchedPlace(const DiamondTree& tree, VertexSlot v, unsigned kind)
{
    return kind == kItself ? tree.place(v).point() : tree.middle(TriangleId(v, kind));
}

void WheelDriver::lookAgain(Frame& frame, std::uint32_t watch, DeferralWheel::Mark mark)
{
    const VertexSlot v = watch >> 3;
    const unsigned kind = watch & 7u;
    if (_marks[v][kind] != mark || frame.tree.place(v).isFree()) return; // nobody waits for this any more
    if (frame.slice.isSpent())
    {
        _marks[v][kind] = kWaits;
        _waiting.push_back(watch);
        return;
    }
    look(frame, v, kind);
}

void WheelDriver::look(Frame& frame, VertexSlot v, unsigned kind)
{
    ++frame.result.checks;
    frame.slice.check();
    const bool itself = kind == kItself;
    const SplitBound bound = frame.tree.tile().bound(watchedPlace(frame.tree, v, kind));
    if (frame.active(bound) == itself) return watch(frame, v, kind, bound);
    _marks[v][kind] = kWaits;
    if (itself)
        _leaving.push_back(v);
    else
        _coming.emplace_back(v, kind);
}

void WheelDriver::watch(Frame& frame, VertexSlot v, unsigned kind, const SplitBound& bound)
{
    _marks[v][kind] = kNotWatched;
    if (bound.errorM <= 0.0f) return; // never active
    const double marginM = std::max(frame.active.marginM(bound) - kRoundingM, 0.0);
    _marks[v][kind] = _wheel.add(watchOf(v, kind), bound.errorM, marginM);
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

/// Coarser vertices first: what stands on them goes along.
bool WheelDriver::letGo(Frame& frame)
{
    DiamondTree& tree = frame.tree;
    std::sort(_leaving.begin(), _leaving.end(),
              [&](VertexSlot a, VertexSlot b) { return tree.place(a).level > tree.place(b).level; });
    while (!_leaving.empty())
    {
        if (frame.slice.isSpent()) return false;
        const VertexSlot v = _leaving.back();
        _leaving.pop_back();
        if (tree.place(v).isFree()) continue;
        const TriangleId parent = tree.parents(v)[0];
        const std::uint32_t merges = tree.enhMerge(v);
        frame.result.merges += merges;
        frame.slice.change(merges);
        look(frame, parent.apex(), parent.quadrant());
    }
    return true;
}

bool WheelDriver::letCome(Frame& frame)
{
    DiamondTree& tree = frame.tree;
    while (!_coming.empty())
    {
        const TriangleId t = _coming.back();
        const bool isDone = _marks[t.apex()][t.quadrant()] != kWaits; // a forced split was first
        if (!isDone && (frame.slice.isSpent() || tree.leafCount() + tree.splitsNeeded(t) > frame.maxLeaves))
            return false;
        _coming.pop_back();
        if (isDone) continue;
        const std::uint32_t splits = tree.forceSplit(t);
        frame.result.splits += splits;
        frame.slice.change(splits);
        followNew(frame);
    }
    return true;
}

std::size_t WheelDriver::memoryBytes() const
{
    return _wheel.memoryBytes() + _marks.capacity() * sizeof(_marks[0]) +
           (_waiting.capacity() + _leaving.capacity() + _coming.capacity()) * sizeof(std::uint32_t);
}

} // namespace osgTerrainROAM::core
