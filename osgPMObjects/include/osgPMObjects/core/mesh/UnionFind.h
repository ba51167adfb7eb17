// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace osgPMObjects::core
{

/// Groups that grow together. The root of a group is its lowest member, so that results do not depend on the order in which
/// groups were joined.
/// Cost: amortised some five steps a question. Source: Tarjan, "Efficiency of a good but not linear set union algorithm" (1975),
/// with path halving; by number instead of by rank.
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
