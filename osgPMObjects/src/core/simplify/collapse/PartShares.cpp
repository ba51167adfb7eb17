// SPDX-License-Identifier: Apache-2.0
#include "PartShares.h"

#include <algorithm>

#include <osgPMObjects/core/mesh/UnionFind.h>

namespace osgPMObjects::core
{

namespace
{

/// Parts that must be in one share.
struct PartGroup
{
    std::vector<std::uint32_t> parts;
    std::size_t faces = 0;
};

std::vector<PartGroup> groupsOf(const CollapseState& state)
{
    constexpr std::uint32_t kNone = ~0u;
    UnionFind together(state.parts.size());
    const auto join = [&](std::uint32_t p, std::uint32_t other)
    {
        if (other != kNone && state.partOf[p] != kNone && state.partOf[other] != kNone)
            together.join(state.partOf[p], state.partOf[other]);
    };
    for (std::uint32_t p = 0; p < state.positions.size(); ++p)
    {
        join(p, state.twins.of(p));
        if (state.orbits.isRound())
            join(p, state.parts.front().positions.front()); // they get less round together
        if (!state.nearby.empty()) join(p, state.nearby[p]);
    }
    std::vector<bool> isLeaf(state.parts.size(), false);
    for (const std::vector<LeafCard>& cards : state.foliage)
        for (const LeafCard& card : cards)
            isLeaf[card.part] = true;
    std::vector<PartGroup> groups(state.parts.size());
    for (std::uint32_t part = 0; part < state.parts.size(); ++part)
    {
        if (isLeaf[part]) continue;
        PartGroup& group = groups[together.root(part)];
        group.parts.push_back(part);
        group.faces += state.parts[part].faces;
    }
    std::erase_if(groups, [](const PartGroup& group) { return group.parts.empty(); });
    return groups;
}

bool hasFewerFaces(const PartGroup& a, const PartGroup& b)
{
    return a.faces < b.faces;
}

} // namespace

std::vector<std::vector<std::uint32_t>> partShares(const CollapseState& state, std::size_t threads)
{
    std::vector<PartGroup> groups = groupsOf(state);
    std::stable_sort(groups.begin(), groups.end(),
                     [](const PartGroup& a, const PartGroup& b) { return hasFewerFaces(b, a); });
    std::vector<PartGroup> shares(
        std::clamp<std::size_t>(groups.size(), 1, std::max<std::size_t>(threads, 1)));
    for (const PartGroup& group : groups) // the largest first, each to the smallest share
    {
        PartGroup& least = *std::min_element(shares.begin(), shares.end(), hasFewerFaces);
        least.parts.insert(least.parts.end(), group.parts.begin(), group.parts.end());
        least.faces += group.faces;
    }
    std::vector<std::vector<std::uint32_t>> parts;
    for (PartGroup& share : shares)
        parts.push_back(std::move(share.parts));
    return parts;
}

} // namespace osgPMObjects::core
