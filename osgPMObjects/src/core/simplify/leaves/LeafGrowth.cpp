// SPDX-License-Identifier: Apache-2.0
#include "LeafGrowth.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace osgPMObjects::core
{

namespace
{

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

} // namespace osgPMObjects::core
