// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <span>

#include <glm/common.hpp>

#include "LeafClosing.h"
#include "LeafGrowth.h"

namespace osgPMObjects::core
{

namespace
{

/// Returns how much a leaf can be scaled about a point within a box, at most `most`.
double mostScale(const Extent& box, std::span<const glm::dvec3> places, const glm::dvec3& about, double most)
{
    for (const glm::dvec3& p : places)
        for (int axis = 0; axis < 3; ++axis)
        {
            const double off = std::abs(p[axis] - about[axis]);
            const double room =
                p[axis] > about[axis] ? box.high[axis] - about[axis] : about[axis] - box.low[axis];
            if (off * most > room) most = room / off;
        }
    return std::max(most, 1.0);
}

} // namespace

LeafGrowth scaledLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays)
{
    const auto before = cornerPositions(state, stays.card);
    const double area = doubleAreaOf(stays.card, before);
    const double wanted = std::min(gone.owedDoubleArea + stays.owedDoubleArea,
                                   (gone.seenDoubleArea + stays.seenDoubleArea) / stays.exposure);
    Leaf both = stays;
    both.takeOver(gone);
    const Extent room = both.room(state.box);
    LeafGrowth best;
    const auto look = [&](const glm::dvec3& from, const glm::dvec3& to)
    {
        LeafGrowth growth;
        for (const glm::dvec3& p : before)
            growth.places.push_back(from == to ? p : p - from + to);
        if (!state.box.contains(extentOf(growth.places))) return;
        const double scale = mostScale(room, growth.places, to, std::sqrt(std::max(1.0, wanted / area)));
        for (glm::dvec3& p : growth.places)
            if (p != to) p = glm::clamp(to + scale * (p - to), state.box.low, state.box.high);
        growth.taken.assign(before.size(), LeafGrowth::kOwn);
        growth.weigh(state, gone, stays);
        if (growth.loss < best.loss) best = std::move(growth);
    };
    for (const glm::dvec3& corner : before)
        look(corner, corner);
    const std::size_t spares =
        closingOf(gone.card, false).left.size() + gone.spares.size() + stays.spares.size();
    if (spares >= before.size()) look(centroidOf(before), both.middle);
    return best;
}

} // namespace osgPMObjects::core
