// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <foundation/Angle.h>

#include "simulation/player/conditions/EntityConditions.h"

namespace simulation
{
namespace
{

double angleOf(const EntityState& state, AngleCondition::Kind kind)
{
    if (kind == AngleCondition::Kind::heading) return foundation::radiansOf(state.headingDeg);
    return foundation::radiansOf(kind == AngleCondition::Kind::pitch ? state.pitchDeg : state.rollDeg);
}

/// On a road headings count from the reference line (`road`), or from the traffic of the lane (`lane`).
double absoluteAngle(const EntityState& state, const AngleCondition& condition)
{
    const bool isOnRoad = condition.frame == DistanceFrame::road || condition.frame == DistanceFrame::lane;
    if (!isOnRoad || !state.place || condition.kind != AngleCondition::Kind::heading)
        return angleOf(state, condition.kind);
    const bool isAgainst = condition.frame == DistanceFrame::lane && state.place->lane > 0;
    return state.place->relativeHeadingRad - (isAgainst ? std::numbers::pi : 0.0);
}

} // namespace

bool holdsFor(const AngleCondition& condition, const EntityFacts& facts, std::size_t entity)
{
    constexpr double kSameAngleRad = 1e-9;
    const EntityState& own = (*facts.states)[entity];
    double angle = absoluteAngle(own, condition);
    if (!condition.entity.empty())
    {
        const int other = facts.scenario->entityIndex(condition.entity);
        if (other < 0) return false;
        angle = angleOf(own, condition.kind) -
                angleOf((*facts.states)[static_cast<std::size_t>(other)], condition.kind);
    }
    const double difference = foundation::wrappedRad(angle - condition.angleRad);
    return std::fabs(difference) <= condition.toleranceRad + kSameAngleRad;
}

} // namespace simulation
