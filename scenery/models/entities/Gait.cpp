// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/Gait.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

namespace scenery::models
{

double Gait::vigour(double speedMps)
{
    constexpr double kFullMps = 0.6;
    return std::clamp(std::abs(speedMps) / kFullMps, 0.0, 1.0);
}

double Gait::phase(double odometerM, double offset) const
{
    const double strides = odometerM / strideM + offset;
    return strides - std::floor(strides);
}

FootPlace footPlace(const Gait& gait, const EntityMotion& motion, double offset)
{
    const double vigour = Gait::vigour(motion.speedMps);
    const double quarter = 0.25 * gait.strideM * vigour;
    const double phase = gait.phase(motion.odometerM, offset);
    if (phase < 0.5) return {quarter * (1.0 - 4.0 * phase), 0.0, 0.0};
    const double swing = 2.0 * (phase - 0.5); // 0…1
    const double ahead = glm::smoothstep(0.0, 1.0, swing);
    return {quarter * (2.0 * ahead - 1.0), gait.liftM * vigour * std::sin(std::numbers::pi * swing),
            0.7 * vigour * std::sin(std::numbers::pi * std::min(1.0, 1.6 * swing))};
}

} // namespace scenery::models
