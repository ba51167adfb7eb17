// SPDX-License-Identifier: Apache-2.0
#include "view/ChaseCamera.h"

#include <algorithm>
#include <cmath>

namespace trainer
{

namespace
{

constexpr int kSightSamples = 8;   ///< of the way from eye to body that are kept above the ground
constexpr double kMostClimb = 0.5; ///< sine of the steepest course that is followed
constexpr double kSightShare =
    0.25; ///< of the clearance that the way to the body keeps, growing towards the eye

} // namespace

glm::dvec3 ChaseCamera::follow(const glm::dvec3& forward, double dtS)
{
    glm::dvec3 wanted(forward.x, forward.y, std::clamp(forward.z, -kMostClimb, kMostClimb));
    const double length = glm::length(wanted);
    wanted = length > 1e-6 ? wanted / length : glm::dvec3(1.0, 0.0, 0.0);
    if (_course == glm::dvec3(0.0)) return wanted;
    const glm::dvec3 mixed = wanted + (_course - wanted) * std::exp(-dtS / _settings.turnTimeS);
    const double mixedLength = glm::length(mixed);
    return mixedLength > 1e-3 ? mixed / mixedLength : wanted; // an about-turn on the spot is followed at once
}

double ChaseCamera::liftFor(const glm::dvec3& eye, const glm::dvec3& target,
                            const simulation::GroundProvider& ground) const
{
    if (!ground) return 0.0;
    double lift = 0.0;
    for (int i = 1; i <= kSightSamples; ++i)
    {
        const double share = static_cast<double>(i) / kSightSamples; // 1 at the eye
        const glm::dvec3 place = target + (eye - target) * share;
        const std::optional<simulation::GroundSample> under = ground(place.x, place.y, place.z);
        if (!under) continue;
        const bool isEye = i == kSightSamples;
        const double clearance = _settings.clearanceM * (isEye ? 1.0 : kSightShare * share);
        // A point on the way rises with the eye by its share.
        lift = std::max(lift, (under->heightM + clearance - place.z) / share);
    }
    return lift;
}

scenery::Pose ChaseCamera::update(const scenery::Pose& body, double dtS,
                                  const simulation::GroundProvider& ground)
{
    const bool isFirst = _course == glm::dvec3(0.0);
    _course = follow(body.forward(), dtS);
    const glm::dvec3 up(0.0, 0.0, 1.0);
    const glm::dvec3 target =
        body.positionWorld + body.forward() * _settings.leadM + up * _settings.lookAtHeightM;
    glm::dvec3 eye = body.positionWorld - _course * _settings.distanceM + up * _settings.heightM;
    const double needed = liftFor(eye, target, ground);
    _liftM = std::max(needed, isFirst ? 0.0 : _liftM * std::exp(-dtS / _settings.settleTimeS));
    eye.z += _liftM;
    return scenery::poseLookingAt(eye, target);
}

} // namespace trainer
