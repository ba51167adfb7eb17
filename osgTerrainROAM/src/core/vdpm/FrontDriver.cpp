// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <osgTerrainROAM/core/vdpm/FrontDriver.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kMarginRoundingM = 1e-6; ///< exceeds the rounding error of a margin by far
constexpr double kTicksPerError = 1.0 / 64.0;
constexpr DeferralWheel::Mark kNotWatched = 0;

/// The step of the wheel's clocks: a part of the size of the finest features.
double tickOf(const BoundedForest& forest)
{
    float least = std::numeric_limits<float>::max();
    for (const SplitBound& bound : forest.bounds)
        if (bound.radiusM > 0.0f) least = std::min(least, bound.radiusM);
    return least < std::numeric_limits<float>::max() ? least * kTicksPerError : 1.0;
}

} // namespace

FrontDriver::FrontDriver(const BoundedForest& forest)
    : _forest(forest),
      _front(forest.forest),
      _wheel(tickOf(forest)),
      _marks(forest.forest.splitCount(), kNotWatched),
      _phases(forest.forest.splitCount(), kInPlace),
      _isHeld(forest.forest.splitCount(), 0),
      _isWanted(forest.forest.splitCount(), 0),
      _dependants(forest.forest.splitCount(), 0)
{
}

bool FrontDriver::refine(const SplitCriterion& criterion, std::uint32_t maxFaces, viewlod::Slice& slice,
                         RefineResult& result)
{
    Frame frame{criterion, maxFaces, slice, result};
    const viewlod::ViewState& view = criterion.view();
    if (_knowsFront)
    {
        const double travelM = glm::distance(view.eyeWorld, _eye) + std::abs(view.nearM - _nearM);
        const double always = criterion.isDeferrable() ? 0.0 : std::numeric_limits<double>::min();
        _wheel.advance(travelM + always, std::abs(criterion.scale() - _scale));
    }
    else
        restart();
    _eye = view.eyeWorld;
    _scale = criterion.scale();
    _nearM = view.nearM;
    checkDue(frame);
    coarsen(frame);
    if (!refineWanted(frame)) return false;
    // What was done for others that wait may be needed no more.
    const auto left = std::partition(_halfDone.begin(), _halfDone.end(),
                                     [this](std::uint32_t split) { return _isHeld[split] != 0; });
    _toCollapse.insert(_toCollapse.end(), left, _halfDone.end());
    _halfDone.erase(left, _halfDone.end());
    coarsen(frame);
    return _toCollapse.empty() && _found.empty() && !_wheel.hasDue();
}

/// Checks everything: nothing is wanted at first.
void FrontDriver::restart()
{
    _wheel.clear();
    _marks.assign(_marks.size(), kNotWatched);
    _isWanted.assign(_isWanted.size(), 0);
    _toSplit.clear();
    _toCollapse.clear();
    _halfDone.clear();
    _knowsFront = true;
    _found = _forest.unfound;
    for (std::uint32_t w = _forest.forest.splitCount(); w-- > 0;)
        if (_front.isDone(w) && !isWanted(w) && _dependants[w] == 0) _toCollapse.push_back(w);
}

/// Checks what the last frame has left to be checked, then what is due.
void FrontDriver::checkDue(Frame& frame)
{
    DeferralWheel::Batch batch;
    for (checkFound(frame); !frame.slice.isSpent(); checkFound(frame))
    {
        _wheel.nextDue(batch);
        frame.slice.handOut(batch.count);
        if (batch.count == 0) return;
        for (std::uint32_t i = 0; i < batch.count; ++i)
        {
            __builtin_prefetch(&_marks[batch.watches[i]]);
            __builtin_prefetch(&_forest.bounds[batch.watches[i]]);
        }
        for (std::uint32_t i = 0; i < batch.count; ++i)
            if (_marks[batch.watches[i]] == batch.marks[i]) check(frame, batch.watches[i]);
    }
}

/// Checks splits whose finders have become wanted, if these still are.
void FrontDriver::checkFound(Frame& frame)
{
    while (!_found.empty() && !frame.slice.isSpent())
    {
        const std::uint32_t split = _found.back();
        _found.pop_back();
        if (const std::uint32_t finder = _forest.finder[split]; finder == kNone || isWanted(finder))
            check(frame, split);
    }
}

/// Decides on a split anew and watches it further.
void FrontDriver::check(Frame& frame, std::uint32_t split)
{
    ++frame.result.checks;
    frame.slice.check();
    const SplitBound& bound = _forest.bounds[split];
    const SplitCriterion::Verdict verdict = frame.criterion.verdict(_forest, split);
    _marks[split] = bound.errorM > 0.0f ? _wheel.add(split, bound.errorM, verdict.marginM - kMarginRoundingM)
                                        : kNotWatched;
    if (verdict.wanted == isWanted(split)) return;
    if (!verdict.wanted) return unwant(split);
    _isWanted[split] = 1;
    if (!_front.isDone(split)) _toSplit.push_back(split);
    const auto found = _forest.foundBy(split);
    _found.insert(_found.end(), found.begin(), found.end());
}

/// Gives up a split and all that were found through it: since bounds nest, none of these is wanted.
void FrontDriver::unwant(std::uint32_t first)
{
    _path.assign(1, first);
    while (!_path.empty())
    {
        const std::uint32_t split = _path.back();
        _path.pop_back();
        _isWanted[split] = 0;
        if (_front.isDone(split) && _dependants[split] == 0) _toCollapse.push_back(split);
        for (const std::uint32_t found : _forest.foundBy(split))
        {
            _marks[found] = kNotWatched;
            if (isWanted(found)) _path.push_back(found);
        }
    }
}

/// Collapses what is neither wanted nor needed, and then what has become so. When vertices move, they only
/// begin to.
void FrontDriver::coarsen(Frame& frame)
{
    while (!_toCollapse.empty() && !frame.slice.isSpent())
    {
        const std::uint32_t split = _toCollapse.back();
        _toCollapse.pop_back();
        if (!_front.isDone(split) || isWanted(split) || _dependants[split] > 0) continue;
        if (_morphFrames > 0)
        {
            if (std::exchange(_phases[split], std::min(_phases[split], _morphFrames)) == kInPlace)
                _moving.push_back(split);
            continue;
        }
        const std::uint32_t before = _front.faceCount();
        remove(split);
        frame.result.merges += before - _front.faceCount();
        frame.slice.change(before - _front.faceCount());
    }
}

void FrontDriver::remove(std::uint32_t split)
{
    _front.ecol(split);
    for (const std::uint32_t needed : _forest.forest.dependenciesOf(split))
        if (--_dependants[needed] == 0 && !isWanted(needed)) _toCollapse.push_back(needed);
}

bool FrontDriver::refineWanted(Frame& frame)
{
    // Coarse splits first: what stops here leaves the finer ones.
    std::ranges::sort(_toSplit, std::greater<>());
    std::size_t left = _toSplit.size(), waiting = 0;
    for (; left > 0; --left)
    {
        const std::uint32_t split = _toSplit[left - 1];
        if (!isWanted(split) || _front.isDone(split)) continue;
        const bool moves = _morphFrames > 0 && frame.criterion.errorPx(_forest, split) <= _mostPx;
        if (!(moves ? begin(frame, split) : force(frame, split))) break;
        if (!_front.isDone(split)) _toSplit[_toSplit.size() - ++waiting] = split; // behind those to come
    }
    _toSplit.erase(_toSplit.begin() + static_cast<std::ptrdiff_t>(left),
                   _toSplit.end() - static_cast<std::ptrdiff_t>(waiting));
    return left == 0;
}

void FrontDriver::doSplit(Frame& frame, std::uint32_t split)
{
    const std::uint32_t before = _front.faceCount();
    _front.vsplit(split);
    frame.result.splits += _front.faceCount() - before;
    frame.slice.change(_front.faceCount() - before);
    for (const std::uint32_t needed : _forest.forest.dependenciesOf(split))
        ++_dependants[needed];
}

/// Begins those splits that one needs, itself included, whose dependencies are in their places. Returns false
/// when a limit stops it.
bool FrontDriver::begin(Frame& frame, std::uint32_t split)
{
    gatherNeeded(split);
    for (const std::uint32_t next : _needed)
    {
        const auto inPlace = [this](std::uint32_t needed) { return isInPlace(needed); };
        if (!_front.isDone(next) && std::ranges::all_of(_forest.forest.dependenciesOf(next), inPlace))
        {
            if (frame.slice.isSpent() || _front.faceCount() + 2 > frame.maxFaces) return false;
            doSplit(frame, next);
            _phases[next] = 0;
            _moving.push_back(next);
        }
        if (!std::exchange(_isHeld[next], 1)) _held.push_back(next);
    }
    return true;
}

void FrontDriver::setMorph(std::uint8_t frames, double mostPx)
{
    if (frames != _morphFrames) stopMoving();
    _morphFrames = frames;
    _mostPx = mostPx;
}

/// Puts all vertices into their places, those that were to go, too.
void FrontDriver::stopMoving()
{
    for (const std::uint32_t split : _moving)
    {
        if (!_front.isDone(split)) continue;
        _phases[split] = kInPlace;
        _front.touch(_forest.forest.v0(split));
        if (!isWanted(split) && _dependants[split] == 0) _toCollapse.push_back(split);
    }
    _moving.clear();
}

void FrontDriver::moveVertices(const SplitCriterion& criterion, RefineResult& result)
{
    const std::vector<std::uint32_t> moving = std::exchange(_moving, {});
    for (const std::uint32_t split : moving)
    {
        std::uint8_t& phase = _phases[split];
        if (!_front.isDone(split) || phase == kInPlace) continue;
        const bool stays = isWanted(split) || _dependants[split] > 0 || _isHeld[split];
        if (!stays && phase == 0)
        {
            phase = kInPlace;
            const std::uint32_t before = _front.faceCount();
            remove(split);
            result.merges += before - _front.faceCount();
            continue;
        }
        _front.touch(_forest.forest.v0(split));
        phase = static_cast<std::uint8_t>(stays ? phase + 1 : phase - 1);
        const bool isLate = stays && criterion.errorPx(_forest, split) > _mostPx;
        if (isLate && phase < _morphFrames) ++_jumps;
        if (phase >= _morphFrames || isLate)
        {
            phase = kInPlace;
            if (!isWanted(split) && _dependants[split] == 0) _halfDone.push_back(split);
        }
        else
            _moving.push_back(split);
    }
    for (const std::uint32_t split : _held)
        _isHeld[split] = 0;
    _held.clear();
}

/// Does a split after all that it needs. Returns false when the ceiling does not allow for them, or when the
/// slice ended on the way.
bool FrontDriver::force(Frame& frame, std::uint32_t split)
{
    gatherNeeded(split);
    if (_front.faceCount() + 2 * _needed.size() > frame.maxFaces) return false;
    std::size_t halfDone = 0;
    for (const std::uint32_t next : _needed)
    {
        if (_front.isDone(next)) // it moves: it has to be in its place now
        {
            _front.touch(_forest.forest.v0(next));
            _phases[next] = kInPlace;
            continue;
        }
        if (frame.slice.isSpent()) return false;
        if (next != split)
        {
            _halfDone.push_back(next);
            ++halfDone;
        }
        doSplit(frame, next);
        _jumps += _morphFrames > 0;
    }
    _halfDone.resize(_halfDone.size() - halfDone);
    return true;
}

/// Lists the splits that are not in place of those that one needs, itself included, in an order in which they
/// can be done: dependencies have smaller numbers.
void FrontDriver::gatherNeeded(std::uint32_t split)
{
    _needed.assign(1, split);
    for (std::size_t i = 0; i < _needed.size(); ++i)
        for (const std::uint32_t needed : _forest.forest.dependenciesOf(_needed[i]))
            if (!isInPlace(needed) && std::ranges::find(_needed, needed) == _needed.end())
                _needed.push_back(needed);
    std::ranges::sort(_needed);
}

std::size_t FrontDriver::waiting() const
{
    return static_cast<std::size_t>(std::ranges::count_if(
        _toSplit, [this](std::uint32_t split) { return isWanted(split) && !_front.isDone(split); }));
}

double FrontDriver::errorBoundPx(const SplitCriterion& criterion) const
{
    if (_wheel.hasDue() || !_found.empty()) return std::numeric_limits<double>::infinity();
    double bound = criterion.tolerancePx();
    for (const std::uint32_t split : _toSplit)
        if (!_front.isDone(split)) bound = std::max(bound, criterion.errorPx(_forest, split));
    return bound;
}

bool FrontDriver::keepsDependencies() const
{
    std::vector<std::uint32_t> counted(_dependants.size(), 0);
    for (std::uint32_t w = 0; w < counted.size(); ++w)
    {
        if (!_front.isDone(w)) continue;
        for (const std::uint32_t needed : _forest.forest.dependenciesOf(w))
        {
            if (!_front.isDone(needed)) return false;
            ++counted[needed];
        }
    }
    if (counted != _dependants) return false;
    if (!_toCollapse.empty() || !_toSplit.empty() || !_found.empty() || !_halfDone.empty() ||
        !_moving.empty() || _wheel.hasDue())
        return true;
    for (std::uint32_t w = 0; w < counted.size(); ++w)
        if (isWanted(w) ? !_front.isDone(w) : _front.isDone(w) && counted[w] == 0) return false;
    return true;
}

std::size_t FrontDriver::memoryBytes() const
{
    return _front.memoryBytes() + _wheel.memoryBytes() + _marks.capacity() + _isWanted.capacity() +
           _phases.capacity() + _isHeld.capacity() +
           sizeof(std::uint32_t) *
               (_dependants.capacity() + _toSplit.capacity() + _toCollapse.capacity() + _found.capacity() +
                _halfDone.capacity() + _needed.capacity() + _path.capacity());
}

} // namespace osgTerrainROAM::core
