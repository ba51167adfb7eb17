// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace osgPMObjects::core
{

/// Disjoint sets of numbers. The root of a set is its lowest member, so results do not depend on the order of
/// joining.
/// Cost: amortised some five steps a query.
/// Source: Tarjan, *Efficiency of a good but not linear set union algorithm* (1975), with path halving.
/// Differs: linked by number, not by rank.
class UnionFind
{
public:
    explicit UnionFind(std::size_t size) : _parent(size) { std::iota(_parent.begin(), _parent.end(), 0u); }

    std::uint32_t root(std::uint32_t i)
    {
        while (_parent[i] != i)
            i = _parent[i] = _parent[_parent[i]];
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b)
    {
        a = root(a);
        b = root(b);
        if (a < b)
            _parent[b] = a;
        else
            _parent[a] = b;
    }

private:
    std::vector<std::uint32_t> _parent;
};

} // namespace osgPMObjects::core
