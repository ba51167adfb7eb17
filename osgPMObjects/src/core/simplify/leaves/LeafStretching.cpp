// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "LeafClosing.h"
#include "LeafGrowth.h"

namespace osgPMObjects::core
{

namespace
{

/// Returns the corner of a card with the same texture coordinates as a corner of another; kOwn where there is
/// none.
std::uint8_t sameCorner(const CollapseState& state, const LeafCard& card, const LeafCard& other,
                        std::size_t corner)
{
    const glm::dvec3 off = state.positions[other.corners[corner].position];
    std::uint8_t best = LeafGrowth::kOwn;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < card.corners.size(); ++c)
    {
        if (!looksTheSame(state, card.corners[c], other.corners[corner])) continue;
        const glm::dvec3 away = state.positions[card.corners[c].position] - off;
        const double squared = glm::dot(away, away);
        if (squared < least) least = squared, best = static_cast<std::uint8_t>(c);
    }
    return best;
}

/// Whether the wanted corners are left when the other card has collapsed, none of them wanted twice.
bool canBeTaken(std::span<const std::uint8_t> taken, const LeafClosing& closing)
{
    std::uint32_t used = 0;
    for (const std::uint8_t corner : taken)
    {
        if (corner == LeafGrowth::kOwn) continue;
        const bool isLeft = std::find(closing.left.begin(), closing.left.end(), corner) != closing.left.end();
        if (!isLeft || (used >> corner & 1u) != 0) return false;
        used |= 1u << corner;
    }
    return true;
}

} // namespace

LeafGrowth stretchedLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays)
{
    const auto before = cornerPositions(state, stays.card);
    const std::array closings{closingOf(gone.card, false), closingOf(gone.card, true)};
    std::vector<std::uint8_t> same;
    for (std::size_t c = 0; c < before.size(); ++c)
        same.push_back(sameCorner(state, gone.card, stays.card, c));
    LeafGrowth best;
    for (std::uint32_t which = 0; which < 1u << before.size(); ++which)
    {
        LeafGrowth growth;
        growth.places = before;
        growth.taken.assign(before.size(), LeafGrowth::kOwn);
        bool isWhole = true;
        for (std::size_t c = 0; c < before.size() && isWhole; ++c)
        {
            if ((which >> c & 1u) == 0) continue;
            growth.taken[c] = same[c];
            isWhole = same[c] != LeafGrowth::kOwn;
            if (isWhole) growth.places[c] = state.positions[gone.card.corners[same[c]].position];
        }
        growth.isTurned = !canBeTaken(growth.taken, closings[0]);
        if (!isWhole || (growth.isTurned && !canBeTaken(growth.taken, closings[1])) ||
            !keepsItsSide(stays.card, before, growth.places))
            continue;
        growth.weigh(state, gone, stays);
        if (growth.loss < best.loss) best = std::move(growth);
    }
    return best;
}

} // namespace osgPMObjects::core
