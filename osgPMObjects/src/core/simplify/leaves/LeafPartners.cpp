// SPDX-License-Identifier: Apache-2.0
#include "LeafPartners.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/PointGrid.h>

namespace osgPMObjects::core
{

namespace
{

/// Search radius of neighbours, as a share of the diagonal of the leaves' box by the cube root of their
/// number: about ten leaves.
constexpr double kNeighbourhood = 0.6;

} // namespace

void LeafPartners::find(std::span<const Leaf> leaves, std::span<const std::uint32_t> left)
{
    _partners.resize(leaves.size());
    Extent extent;
    for (const std::uint32_t leaf : left)
        extent.add(leaves[leaf].middle);
    double distance = kNeighbourhood * std::max(extent.diagonal(), 1e-9) / std::cbrt(double(left.size()));
    while (findWithin(distance, leaves, left) == 0)
        distance *= 2.0;
}

/// Finds partners for leaves without one. Returns how many leaves have one now.
std::size_t LeafPartners::findWithin(double distance, std::span<const Leaf> leaves,
                                     std::span<const std::uint32_t> left)
{
    PointGrid grid(distance, left.size());
    for (const std::uint32_t leaf : left)
        grid.add(leaves[leaf].middle);
    std::size_t found = 0;
    for (const std::uint32_t leaf : left)
    {
        Partner& best = _partners[leaf];
        const glm::dvec3& middle = leaves[leaf].middle;
        const auto look = [&](std::uint32_t number)
        {
            const std::uint32_t other = left[number];
            const glm::dvec3 away = leaves[other].middle - middle;
            if (other == leaf || !(glm::dot(away, away) <= distance * distance)) return;
            const double cost = this->cost(leaves[leaf], leaves[other]);
            if (cost < best.cost || (cost == best.cost && other < best.leaf)) best = {cost, other};
        };
        if (best.leaf == kNone) grid.visitBox(middle - distance, middle + distance, look);
        found += best.leaf != kNone;
    }
    return found;
}

double LeafPartners::cost(const Leaf& a, const Leaf& b) const
{
    const glm::dvec3 away = a.middle - b.middle;
    const double moved = a.seenDoubleArea * b.seenDoubleArea / (a.seenDoubleArea + b.seenDoubleArea);
    return _weight.of(moved) *
           (glm::dot(away, away) + kMissedLeaf * std::min(a.owedDoubleArea, b.owedDoubleArea));
}

} // namespace osgPMObjects::core
