// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/LegBend.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace scenery::models
{

namespace
{

glm::dvec3 hungFrom(const glm::dvec3& origin, double lengthM, double forwardsRad)
{
    return origin + lengthM * glm::dvec3(std::sin(forwardsRad), 0.0, -std::cos(forwardsRad));
}

} // namespace

LegBend bendLeg(const Leg& leg, const glm::dvec3& hip, const glm::dvec3& target)
{
    constexpr double kLeastM = 1e-3;
    const double dx = target.x - hip.x, down = hip.z - target.z;
    const double away = std::clamp(std::hypot(dx, down), std::abs(leg.upperM - leg.lowerM) + kLeastM,
                                   leg.upperM + leg.lowerM - kLeastM);
    const double cosine =
        (leg.upperM * leg.upperM + away * away - leg.lowerM * leg.lowerM) / (2.0 * leg.upperM * away);
    const double inner = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double line = std::atan2(dx, down);
    LegBend bend;
    bend.upperRad = line + (leg.jointAhead ? inner : -inner);
    bend.joint = hungFrom(hip, leg.upperM, bend.upperRad);
    bend.end = hungFrom(hip, away, line);
    bend.lowerRad = std::atan2(bend.end.x - bend.joint.x, bend.joint.z - bend.end.z);
    return bend;
}

glm::dmat4 swungFrom(const glm::dvec3& origin, double forwardsRad)
{
    return glm::rotate(glm::translate(glm::dmat4(1.0), origin), -forwardsRad, glm::dvec3(0.0, 1.0, 0.0));
}

} // namespace scenery::models
