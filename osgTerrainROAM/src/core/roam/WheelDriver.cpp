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
        if (isWanted(frame, watch, kWaits))
            lookAgain(frame, watch, watchedPlace(frame.tree, watch >> 3, watch & 7u));
}

/// The work is waiting for memory; so it goes in small batches, of which all places are found before the first is looked at.
void WheelDriver::lookAtDue(Frame& frame, std::span<const DeferralWheel::Handout> due)
{
    constexpr std::size_t kBatch = 16;
    std::array<GridPoint, kBatch> places;
    std::array<DeferralWheel::Handout, kBatch> wanted;
    while (!due.empty())
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
            if (!isWanted(frame, handout.watch, handout.mark)) continue;
            places[count] = watchedPlace(frame.tree, handout.watch >> 3, handout.watch & 7u);
            frame.tree.tile().prefetch(places[count]);
            wanted[count++] = handout;
        }
        for (std::size_t i = 0; i < count; ++i)
            if (isWanted(frame, wanted[i].watch, wanted[i].mark))
                lookAgain(frame, wanted[i].watch, places[i]);
    }
}

GridPoint WheelDriver::watchedPlace(const DiamondTree& tree, VertexSlot v, unsigned kind)
{
    return kind == kItself ? tree.place(v).point() : tree.middle(TriangleId(v, kind));
}

/// Whether anybody still waits for a watch that is handed out.
bool WheelDriver::isWanted(const Frame& frame, std::uint32_t watch, DeferralWheel::Mark mark) const
{
    return _marks[watch >> 3][watch & 7u] == mark && !frame.tree.place(watch >> 3).isFree();
}

void WheelDriver::lookAgain(Frame& frame, std::uint32_t watch, GridPoint place)
{
    if (!frame.slice.isSpent()) return look(frame, watch >> 3, watch & 7u, place);
    _marks[watch >> 3][watch & 7u] = kWaits;
    _waiting.push_back(watch);
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
        const bool canChange = bound.errorM > 0.0f;
        mark = canChange
                   ? _wheel.add(watchOf(v, kind), bound.errorM, std::max(verdict.marginM - kRoundingM, 0.0))
                   : kNotWatched;
        return;
    }
    mark = kWaits;
    if (kind == kItself)
        _leaving.push_back(v);
    else
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
