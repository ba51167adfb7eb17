// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/HullWater.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

namespace
{

constexpr double kWaterKgPerM3 = 1000.0, kPlateDrag = 1.1;
constexpr double kStillPerS = 1.2; ///< damping of slow motion, times the mass of the water that is moved

} // namespace

void pressByWater(const HullData& hull, const glm::dvec3& centre, const SolidMotion& motion,
                  const HullWater& water,
                  const std::function<void(const glm::dvec3& force, const glm::dvec3& arm)>& press)
{
    const glm::dmat3 body = glm::mat3_cast(motion.bodyToScene);
    for (const HullBox& box : hull.boxes)
        for (const double x : {-0.25, 0.25})
            for (const double y : {-0.25, 0.25})
            {
                const glm::dvec3 place = box.place + box.sizeM * glm::dvec3(x, y, 0.0) - centre;
                const glm::dvec3 arm = motion.bodyToScene * place;
                const glm::dvec3 half = 0.25 * glm::dvec3(box.sizeM.x, box.sizeM.y, 2.0 * box.sizeM.z);
                const double high = half.x * std::abs(body[0].z) + half.y * std::abs(body[1].z) +
                                    half.z * std::abs(body[2].z);
                const double under =
                    std::clamp((water.levelM - motion.position.z - arm.z + high) / (2.0 * high), 0.0, 1.0);
                if (under <= 0.0) continue;
                const double displacedKg = kWaterKgPerM3 * under * 8.0 * half.x * half.y * half.z;
                press(-water.airShare * displacedKg * water.gravityMps2, arm);
                const glm::dvec3 velocity = motion.velocity + glm::cross(motion.rates, arm);
                const glm::dvec3 inBody = glm::conjugate(motion.bodyToScene) * velocity;
                const glm::dvec3 area =
                    4.0 * under * glm::dvec3(half.y * half.z, half.x * half.z, half.x * half.y);
                glm::dvec3 drag = -0.5 * kWaterKgPerM3 * kPlateDrag * area * glm::abs(inBody) * inBody -
                                  kStillPerS * displacedKg * inBody;
                const glm::dvec3 most = water.mostNsPerM * glm::abs(inBody);
                drag = glm::clamp(drag, -most, most);
                press(motion.bodyToScene * drag, arm);
            }
}

} // namespace simulation
