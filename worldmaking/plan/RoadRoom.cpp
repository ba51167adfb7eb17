// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/plan/RoadRoom.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

#include "scenery/buildings/Outline.h"

namespace worldmaking
{

namespace
{

using osgRoads::core::RoadMatch;

constexpr double kStepM = 1.0;
constexpr int kMostCuts = 12;
constexpr double kCutMarginM = 0.02; ///< so that rounding leaves no second cut

/// A half of the plan: the points with dot(point - at, out) ≥ 0 stay.
struct HalfPlan
{
    glm::dvec2 at{0.0}, out{1.0, 0.0};

    double insideM(const glm::dvec2& place) const { return glm::dot(place - at, out); }
};

std::vector<glm::dvec2> cut(const std::vector<glm::dvec2>& ring, const HalfPlan& half)
{
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        const double da = half.insideM(a), db = half.insideM(b);
        if (da >= 0.0) kept.push_back(a);
        if ((da >= 0.0) != (db >= 0.0)) kept.push_back(glm::mix(a, b, da / (da - db)));
    }
    return kept;
}

glm::dvec2 middleOf(const std::vector<glm::dvec2>& ring)
{
    glm::dvec2 sum(0.0);
    for (const glm::dvec2& corner : ring)
        sum += corner;
    return sum / static_cast<double>(ring.size());
}

/// Calls `look` for places along the edges of rings.
template<class Look>
void alongEdges(const PlanRings& rings, const Look& look)
{
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(b - a) / kStepM)));
            for (int k = 0; k < steps; ++k)
                look(glm::mix(a, b, static_cast<double>(k) / steps));
        }
}

} // namespace

std::optional<RoadMatch> RoadRoom::nearest(const glm::dvec2& place, double withinM) const
{
    for (const RoadMatch& match : _locator.within(place, withinM))
    {
        const auto& road = _network.roads[static_cast<std::size_t>(match.position.road)];
        const auto* structure = osgRoads::core::structureAt(road, match.position.s);
        if (!structure || structure->kind == osgRoads::core::StructureKind::bridge) return match;
    }
    return std::nullopt;
}

double RoadRoom::distanceM(const glm::dvec2& place, double withinM) const
{
    const auto match = nearest(place, withinM);
    return match ? match->distance : withinM;
}

double RoadRoom::distanceM(const PlanRings& rings, double withinM) const
{
    double least = withinM;
    alongEdges(rings, [&](const glm::dvec2& place) { least = std::min(least, distanceM(place, withinM)); });
    return least;
}

std::optional<PlanRings> RoadRoom::cutBack(PlanRings rings, double roomM, double leastShare) const
{
    const double whole = scenery::areaOf(rings);
    for (int i = 0; i < kMostCuts; ++i)
    {
        std::optional<RoadMatch> worst;
        double mostM = -1.0; // how far the nearest edge of the road lies inside the outline
        HalfPlan half;
        const glm::dvec2 middle = middleOf(rings.front());
        alongEdges(rings,
                   [&](const glm::dvec2& place)
                   {
                       const auto match = nearest(place, roomM);
                       if (!match) return;
                       const auto& road = _network.roads[static_cast<std::size_t>(match->position.road)];
                       const auto frame = osgRoads::core::frameAt(road, match->position.s);
                       const auto lanes = osgRoads::core::extentAt(road, match->position.s);
                       const double lateral = glm::dot(middle - glm::dvec2(frame.origin), frame.left());
                       const double side = lateral > 0.5 * (lanes.leftT + lanes.rightT) ? 1.0 : -1.0;
                       const double edge = side > 0.0 ? lanes.leftT : lanes.rightT;
                       const glm::dvec2 out = side * frame.left();
                       const HalfPlan found{
                           glm::dvec2(frame.origin) + frame.left() * edge + out * (roomM + kCutMarginM), out};
                       const double insideM = -found.insideM(place);
                       if (insideM <= mostM) return;
                       mostM = insideM;
                       half = found;
                       worst = match;
                   });
        if (!worst) return rings;
        for (auto& ring : rings)
            ring = cut(ring, half);
        rings = scenery::tidiedRings(rings);
        if (rings.empty() || scenery::areaOf(rings) < leastShare * whole) return std::nullopt;
    }
    return std::nullopt;
}

} // namespace worldmaking
