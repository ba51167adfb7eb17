// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/earth/WaterArea.h"

#include <algorithm>

#include <foundation/NearestOnSegment.h>
#include <glm/glm.hpp>

#include "scenery/buildings/Outline.h"

namespace worldmaking
{

namespace
{

constexpr double kShoreStepM = 10.0, kBeyondShoreM = 8.0;

std::optional<double> lowGroundM(const PlanRings& rings, const glm::dvec2& edge, const glm::dvec2& along,
                                 const foundation::HeightInPlan& ground)
{
    const glm::dvec2 out = kBeyondShoreM / std::max(glm::length(along), 1e-9) * glm::dvec2(along.y, -along.x);
    const auto at = ground(edge);
    const auto beyond = ground(scenery::isWithin(rings, edge + out) ? edge - out : edge + out);
    return at && beyond ? std::optional(std::min(*at, *beyond)) : std::nullopt;
}

} // namespace

double shoreDistanceM(const PlanRings& area, const glm::dvec2& place)
{
    double least = 1e300;
    for (const auto& ring : area)
        for (std::size_t i = 0; i < ring.size(); ++i)
            least = std::min(least, glm::distance(place, foundation::nearestOnSegment(
                                                             place, ring[i], ring[(i + 1) % ring.size()])));
    return least;
}

std::optional<std::vector<double>> shoreOf(const PlanRings& rings, const foundation::HeightInPlan& ground)
{
    std::vector<double> heights;
    for (const auto& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
            const int steps = std::max(1, static_cast<int>(glm::distance(a, b) / kShoreStepM));
            for (int step = 0; step < steps; ++step)
            {
                const auto height = lowGroundM(rings, glm::mix(a, b, (step + 0.5) / steps), b - a, ground);
                if (!height) return std::nullopt;
                heights.push_back(*height);
            }
        }
    std::sort(heights.begin(), heights.end());
    return heights.empty() ? std::nullopt : std::optional(heights);
}

} // namespace worldmaking
