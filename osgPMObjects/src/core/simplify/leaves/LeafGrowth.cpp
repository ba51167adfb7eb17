// SPDX-License-Identifier: Apache-2.0
#include "LeafGrowth.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

namespace
{

constexpr double kFlattest = 0.5; ///< cosine between the normals of a changed leaf's faces: 60°
constexpr double kTurned = 0.2;   ///< cosine between a face's normals before and after

double squaredLength(const glm::dvec3& v)
{
    return glm::dot(v, v);
}

/// The cost of moving both areas to `middle`.
double costOf(const CollapseState& state, const Leaf& gone, const Leaf& stays, const glm::dvec3& middle)
{
    return state.weight.of(gone.seenDoubleArea) * squaredLength(middle - gone.middle) +
           state.weight.of(stays.seenDoubleArea) * squaredLength(middle - stays.middle);
}

} // namespace

void LeafGrowth::weigh(const CollapseState& state, const Leaf& gone, const Leaf& stays)
{
    const double owed = gone.owedDoubleArea + stays.owedDoubleArea;
    cost = costOf(state, gone, stays, centroidOf(places));
    loss = cost + state.weight.of(std::abs(owed - doubleAreaOf(stays.card, places))) * owed;
}

bool LeafGrowth::takesCorners() const
{
    return std::any_of(taken.begin(), taken.end(), [](std::uint8_t corner) { return corner != kOwn; });
}

bool looksTheSame(const CollapseState& state, const LeafCard::Corner& a, const LeafCard::Corner& b)
{
    if (!state.settings.keepSeams) return true;
    const Wedge ofA = wedgeOf(state.mesh, a.wedges.front()), ofB = wedgeOf(state.mesh, b.wedges.front());
    double drift = 0.0;
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
        drift = std::max(drift, double(glm::distance(ofA.texCoords[set], ofB.texCoords[set])));
    return drift <= state.settings.mostTexCoordDrift;
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

} // namespace osgPMObjects::core
