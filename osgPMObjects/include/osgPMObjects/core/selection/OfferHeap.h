// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace osgPMObjects::core
{

/// One object's next point, finer or coarser, and what it gains or loses for its cost.
struct Offer
{
    double rate = 0.0; ///< benefit by cost
    std::uint32_t object = 0;
    std::uint32_t point = 0; ///< of the object when the offer was made: stale when that has changed
};

/// Offers of objects, the best on top: the largest rate where `finer`, the smallest where not; of equal ones the smaller
/// number's. Offers that have become stale stay until they are on top. Memory: kept when emptied.
template<bool finer>
class OfferHeap
{
public:
    void clear()
    {
        _offers.clear();
        _isOrdered = false;
    }

    /// Cost: constant until the first question for the top, which orders all; then log n.
    void push(const Offer& offer)
    {
        _offers.push_back(offer);
        if (_isOrdered) std::push_heap(_offers.begin(), _offers.end(), isAfter);
    }

    /// The best that stands, or null. `points`: by object, where each is now.
    const Offer* top(std::span<const std::uint32_t> points)
    {
        if (!_isOrdered) std::make_heap(_offers.begin(), _offers.end(), isAfter);
        _isOrdered = true;
        while (!_offers.empty() && _offers.front().point != points[_offers.front().object])
            pop();
        return _offers.empty() ? nullptr : &_offers.front();
    }

    /// After top().
    void pop()
    {
        std::pop_heap(_offers.begin(), _offers.end(), isAfter);
        _offers.pop_back();
    }

    /// Drops those for which `isHopeless(offer)`. Cost: linear.
    template<class IsHopeless>
    void drop(const IsHopeless& isHopeless)
    {
        std::erase_if(_offers, isHopeless);
        _isOrdered = false;
    }

private:
    static bool isAfter(const Offer& a, const Offer& b)
    {
        if (a.rate != b.rate) return finer ? a.rate < b.rate : a.rate > b.rate;
        return a.object > b.object;
    }

    std::vector<Offer> _offers;
    bool _isOrdered = false;
};

} // namespace osgPMObjects::core
