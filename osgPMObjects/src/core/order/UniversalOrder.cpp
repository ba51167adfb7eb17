// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include <osgPMObjects/core/order/TriangleOrders.h>

#include "GraphBisection.h"

namespace osgPMObjects::core
{

namespace
{

/// Orders triangles by recursive bisection of the dual graph. Source: see universalOrder().
class UniversalSorter
{
public:
    explicit UniversalSorter(std::span<const Triangle> triangles)
        : _adjacency(triangles), _bisection(_adjacency), _order(triangles.size()), _range(triangles.size(), 0)
    {
        std::iota(_order.begin(), _order.end(), 0u);
    }

    std::vector<std::uint32_t> run()
    {
        std::vector<Range> open{{0, _order.size()}};
        while (!open.empty())
        {
            const Range range = open.back();
            open.pop_back();
            if (range.end - range.begin < 2) continue;
            const std::size_t middle = halve(range);
            open.push_back({middle, range.end});
            open.push_back({range.begin, middle});
        }
        return std::move(_order);
    }

private:
    struct Range
    {
        std::size_t begin, end;
    };

    std::size_t halve(const Range& range)
    {
        const auto all = std::span(_order).subspan(range.begin, range.end - range.begin);
        const std::size_t first = _bisection.halve(all);
        if (pull(all.first(first), range) < pull(all.subspan(first), range))
            std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
        else
            return label(range, range.begin + first);
        return label(range, range.end - first);
    }

    /// Returns the neighbours that are drawn before the range minus those drawn after it; its halves have no
    /// order yet.
    std::ptrdiff_t pull(std::span<const std::uint32_t> half, const Range& range) const
    {
        std::ptrdiff_t sum = 0;
        for (const std::uint32_t t : half)
            for (const std::uint32_t n : _adjacency.neighbours(t))
                if (n != TriangleAdjacency::kNone)
                {
                    if (_range[n] < range.begin)
                        ++sum;
                    else if (_range[n] >= range.end)
                        --sum;
                }
        return sum;
    }

    std::size_t label(const Range& range, std::size_t middle)
    {
        for (std::size_t i = range.begin; i < range.end; ++i)
            _range[_order[i]] = static_cast<std::uint32_t>(i < middle ? range.begin : middle);
        return middle;
    }

    TriangleAdjacency _adjacency;
    GraphBisection _bisection;
    std::vector<std::uint32_t> _order;
    std::vector<std::uint32_t> _range; ///< by triangle: the beginning of its current range
};

} // namespace

std::vector<std::uint32_t> universalOrder(std::span<const Triangle> triangles)
{
    return UniversalSorter(triangles).run();
}

} // namespace osgPMObjects::core
