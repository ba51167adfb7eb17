// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace osgPMObjects::core
{

/// A candidate step of one object to its next finer or coarser point, with the benefit that it gains or loses
/// for its cost.
struct LevelCandidate
{
    double rate = 0.0; ///< benefit divided by cost
    std::uint32_t object = 0;
    std::uint32_t point =
        0; ///< the object's point at the time of push(); the candidate is stale once that has changed
};

/// A heap of candidates. Its top has the largest rate if `finer`, else the smallest; the smaller object
/// number wins a tie. Stale candidates are removed when they reach the top. Memory: kept by clear().
template<bool finer>
class CandidateHeap
{
public:
    void clear()
    {
        _candidates.clear();
        _isOrdered = false;
    }

    /// Adds a candidate. Cost: constant before the first top(), which orders the heap; then log n.
    void push(const LevelCandidate& candidate)
    {
        _candidates.push_back(candidate);
        if (_isOrdered) std::push_heap(_candidates.begin(), _candidates.end(), isAfter);
    }

    /// Returns the best candidate that is not stale, or null. `points`: by object, its current point.
    const LevelCandidate* top(std::span<const std::uint32_t> points)
    {
        if (!_isOrdered) std::make_heap(_candidates.begin(), _candidates.end(), isAfter);
        _isOrdered = true;
        while (!_candidates.empty() && _candidates.front().point != points[_candidates.front().object])
            pop();
        return _candidates.empty() ? nullptr : &_candidates.front();
    }

    /// Removes the candidate that top() returned.
    void pop()
    {
        std::pop_heap(_candidates.begin(), _candidates.end(), isAfter);
        _candidates.pop_back();
    }

    /// Removes the candidates for which `isHopeless(candidate)`. Cost: linear.
    template<class IsHopeless>
    void drop(const IsHopeless& isHopeless)
    {
        std::erase_if(_candidates, isHopeless);
        _isOrdered = false;
    }

private:
    static bool isAfter(const LevelCandidate& a, const LevelCandidate& b)
    {
        if (a.rate != b.rate) return finer ? a.rate < b.rate : a.rate > b.rate;
        return a.object > b.object;
    }

    std::vector<LevelCandidate> _candidates;
    bool _isOrdered = false;
};

} // namespace osgPMObjects::core
