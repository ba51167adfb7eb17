// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/Wedge.h>

#include "LeafClosing.h"
#include "LeafGrowth.h"

namespace osgPMObjects::core
{

namespace
{

constexpr double kFlattest = 0.5; ///< cosine between the normals of a stretched leaf's faces: 60°
constexpr double kTurned = 0.2;   ///< cosine between a face's normals before and after

/// Returns the corner of a card with the same texture coordinates as a corner of another; kOwn where there is none.
std::uint8_t sameCorner(const CollapseState& state, const LeafCard& card, const LeafCard& other,
                        std::size_t corner)
{
    const glm::dvec3 off = state.positions[other.corners[corner].position];
    std::uint8_t best = LeafGrowth::kOwn;
    double least = std::numeric_limits<double>::infinity();
    const Wedge looks = wedgeOf(state.mesh, other.corners[corner].wedges.front());
    for (std::uint8_t c = 0; c < card.corners.size(); ++c)
    {
        const Wedge own = wedgeOf(state.mesh, card.corners[c].wedges.front());
        double drift = 0.0;
        for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
            drift = std::max(drift, double(glm::distance(own.texCoords[set], looks.texCoords[set])));
        if (state.settings.keepSeams && drift > state.settings.mostTexCoordDrift) continue;
        const glm::dvec3 away = state.positions[card.corners[c].position] - off;
        const double squared = glm::dot(away, away);
        if (squared < least) least = squared, best = c;
    }
    return best;
}

bool keepsItsSide(const LeafCard& card, std::span<const glm::dvec3> before, std::span<const glm::dvec3> after)
{
    glm::dvec3 first(0.0);
    for (const LeafCard::Corners& corners : card.faces)
    {
        const glm::dvec3 was = doubleAreaVector(corners, before), is = doubleAreaVector(corners, after);
        if (!(glm::dot(was, is) > kTurned * glm::length(was) * glm::length(is))) return false;
        // A card with two sides has faces of opposite normals.
        if (first == glm::dvec3(0.0)) first = is;
        if (!(std::abs(glm::dot(first, is)) >= kFlattest * glm::length(first) * glm::length(is)))
            return false;
    }
    return true;
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
    std::array<std::uint8_t, LeafCard::kMostCorners> same{};
    for (std::size_t c = 0; c < before.size(); ++c)
        same[c] = sameCorner(state, gone.card, stays.card, c);
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
