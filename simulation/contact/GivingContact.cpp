// SPDX-License-Identifier: Apache-2.0
#include "simulation/contact/GivingContact.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

namespace
{

glm::dvec2 acrossOf(const glm::dvec2& along)
{
    return {-along.y, along.x};
}

/// Half the width of a box seen along an axis.
double shadowOf(const glm::dvec2& along, const glm::dvec2& halfM, const glm::dvec2& axis)
{
    return halfM.x * std::abs(glm::dot(along, axis)) + halfM.y * std::abs(glm::dot(acrossOf(along), axis));
}

bool areApart(const HullPlan& hull, const Obstacle& obstacle, const glm::dvec2& axis)
{
    const double apart = std::abs(glm::dot(obstacle.middle - hull.middle, axis));
    return apart > shadowOf(hull.along, hull.halfM, axis) + shadowOf(obstacle.along, obstacle.halfM, axis);
}

} // namespace

bool overlaps(const HullPlan& hull, const Obstacle& obstacle)
{
    if (hull.lowM > obstacle.highM || hull.highM < obstacle.lowM) return false;
    const glm::dvec2 apart = obstacle.middle - hull.middle;
    const glm::dvec2 inHull(glm::dot(apart, hull.along), glm::dot(apart, acrossOf(hull.along)));
    if (obstacle.isRound)
    {
        const glm::dvec2 nearest = glm::clamp(inHull, -hull.halfM, hull.halfM);
        return glm::distance(nearest, inHull) <= obstacle.halfM.x;
    }
    for (const glm::dvec2& axis :
         {hull.along, acrossOf(hull.along), obstacle.along, acrossOf(obstacle.along)})
        if (areApart(hull, obstacle, axis)) return false;
    return true;
}

GivingBlow blowOf(ObstacleKind kind, double speedMps, double massKg, double inverseMass, double stepS)
{
    const ObstacleFacts facts = factsOf(kind);
    const double stops = speedMps / inverseMass;
    if (facts.breaksNs > 0.0) return {std::min(facts.breaksNs, stops), facts.breaksNs < stops};
    const double slows = massKg * stepS * (facts.slowsPerM * speedMps * speedMps + facts.slowsMps2);
    return {std::min(slows, stops), false};
}

} // namespace simulation
