// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/cockpit/SteeringWheel.h"

#include <cmath>
#include <numbers>

#include "scenery/models/cockpit/InteriorShell.h"
#include "scenery/models/entities/Loft.h"

namespace scenery::models
{

Model makeSteeringWheel(double radiusM)
{
    constexpr int kAround = 40, kAcross = 10;
    constexpr double kRimM = 0.014;
    ModelBuilder builder;
    builder.begin("rim", kPlain, kSeam);
    std::vector<std::vector<Corner>> rows;
    for (int i = 0; i <= kAround; ++i)
    {
        const double turn = 2.0 * std::numbers::pi * (i % kAround) / kAround;
        const glm::dvec3 out(std::sin(turn), std::cos(turn), 0.0);
        std::vector<Corner>& row = rows.emplace_back();
        for (int k = 0; k <= kAcross; ++k)
        {
            const double round = 2.0 * std::numbers::pi * (k % kAcross) / kAcross;
            row.push_back(
                {out * (radiusM + kRimM * std::cos(round)) + glm::dvec3(0.0, 0.0, kRimM * std::sin(round)),
                 plainUv()});
        }
    }
    builder.grid(rows);
    builder.tint({0.16F, 0.16F, 0.17F});
    for (const double turn : {0.5 * std::numbers::pi, -0.5 * std::numbers::pi, std::numbers::pi})
        addPost(builder, {0.0, 0.0, -0.02}, {radiusM * std::sin(turn), radiusM * std::cos(turn), 0.0}, 0.013);
    addLimb(builder, {0.0, 0.0, -0.05}, {0.0, 0.0, -0.01}, 0.05, 0.05);
    return builder.finish();
}

} // namespace scenery::models
