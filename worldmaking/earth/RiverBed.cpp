// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/earth/RiverBed.h"

#include <algorithm>

#include <glm/glm.hpp>

#include "scenery/buildings/Outline.h"

namespace worldmaking
{

std::optional<RiverBed> bedAcross(const PlanRings& area, const glm::dvec2& place, const glm::dvec2& along)
{
    if (!(glm::length(along) > 0.0) || !scenery::isWithin(area, place)) return std::nullopt;
    const glm::dvec2 ahead = glm::normalize(along), left(-ahead.y, ahead.x);
    double leftM = 2.0 * kMostHalfM, rightM = 2.0 * kMostHalfM;
    for (const auto& ring : area)
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const glm::dvec2 a = ring[i] - place, b = ring[(i + 1) % ring.size()] - place;
            const double aheadA = glm::dot(a, ahead), aheadB = glm::dot(b, ahead);
            if ((aheadA < 0.0) == (aheadB < 0.0)) continue;
            const double side = glm::dot(glm::mix(a, b, aheadA / (aheadA - aheadB)), left);
            (side > 0.0 ? leftM : rightM) = std::min(side > 0.0 ? leftM : rightM, std::abs(side));
        }
    if (leftM > kMostHalfM || rightM > kMostHalfM) return std::nullopt;
    return RiverBed{place + 0.5 * (leftM - rightM) * left, leftM + rightM};
}

} // namespace worldmaking
