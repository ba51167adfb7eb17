// SPDX-License-Identifier: Apache-2.0
// What a road vehicle asks of the ground.
#include <algorithm>
#include <cmath>

#include "simulation/vehicle/road/RoadVehicle.h"

namespace simulation
{

namespace
{

constexpr double kHullNearM = 0.08;   ///< between hull and ground, from where on the hull meets it
constexpr double kDeepestShare = 0.9; ///< of the radius; deeper wheels are lifted out

} // namespace

/// Asks for the ground below all wheels and below the corners of the hull, where a step takes them.
void RoadVehicle::lookAtGround(const Ground& ground)
{
    std::array<glm::dvec3, 4 * WheelGround::kMostPoints + 8> points;
    std::array<GroundPoint, points.size()> answers;
    std::array<std::size_t, 4> counts{};
    std::size_t count = 0;
    const Axes body = axes();
    for (std::size_t i = 0; i < 4; ++i)
    {
        RoadWheel& wheel = _wheels[i];
        const RoadTyreData& tyre = _data->axles[i / 2].tyre;
        glm::dvec3 forward = std::cos(wheel.steerRad) * body.forward + std::sin(wheel.steerRad) * body.left;
        forward.z = 0.0;
        const double length = glm::length(forward);
        forward = length > 1e-3 ? forward / length : glm::dvec3(1.0, 0.0, 0.0);
        const auto asked = wheel.ground.pointsFor(hubOf(i), forward, tyre.radiusM, tyre.widthM,
                                                  glm::dot(_motion.velocity, forward) * kStepS);
        std::copy(asked.begin(), asked.end(), points.begin() + static_cast<std::ptrdiff_t>(count));
        counts[i] = asked.size();
        count += asked.size();
    }
    const std::size_t firstCorner = count;
    double reach = 0.0;
    const auto addCorners = [&](const HullBox& box)
    {
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5})
            {
                glm::dvec3 corner = box.place - _mass.centre + box.sizeM * glm::dvec3(x, y, -0.5);
                reach = std::max(reach, glm::length(glm::dvec2(corner)) + box.sizeM.z);
                points[count++] = _motion.position + _motion.bodyToScene * corner + _motion.velocity * kStepS;
            }
    };
    addCorners(_data->hull.boxes.front());
    ground.heightsBelow({points.data(), count}, {answers.data(), count});
    std::size_t first = 0;
    for (std::size_t i = 0; i < 4; ++i)
    {
        _wheels[i].ground.take({answers.data() + first, counts[i]});
        first += counts[i];
    }
    double nearest = body.up.z > 0.7 ? 1e9 : -1.0;
    for (std::size_t i = firstCorner; i < count; ++i)
        if (answers[i].isKnown) nearest = std::min(nearest, points[i].z - answers[i].heightM);
    if (nearest < kHullNearM)
        _world->layGround(_body, ground, reach + 0.5);
    else
        _world->liftGround(_body);
}

/// Wheels far below the ground (a cliff, a start inside a hill) are lifted, without speed of their own.
void RoadVehicle::liftOutOfGround()
{
    double deepest = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
    {
        const RoadTyreData& tyre = _data->axles[i / 2].tyre;
        if (!_wheels[i].ground.isKnown()) continue;
        const WheelContact contact = _wheels[i].ground.contactOf(hubOf(i), tyre.radiusM);
        deepest = std::max(deepest, contact.depthM - (1.0 + kDeepestShare) * tyre.radiusM);
    }
    if (deepest <= 0.0) return;
    crash("it hit the ground");
    _motion.position.z += deepest;
    _motion.velocity.z = std::max(0.0, _motion.velocity.z);
    _world->place(_body, _motion);
}

} // namespace simulation
