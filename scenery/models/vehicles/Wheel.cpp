// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/vehicles/Wheel.h"

#include <array>
#include <cmath>
#include <numbers>

namespace scenery::models
{

void addWheel(ModelBuilder& builder, const Wheel& wheel)
{
    constexpr int kSides = 20; // a multiple of 4, so that a corner stands on the ground
    struct Step
    {
        double outM, radius; ///< shares of half the width and of the radius
    };
    constexpr std::array<Step, 11> kProfile{{{-0.9, 0.0},
                                             {-0.9, 0.70},
                                             {-1.0, 0.86},
                                             {-0.72, 1.0},
                                             {0.72, 1.0},
                                             {1.0, 0.86},
                                             {0.96, 0.70},
                                             {0.86, 0.67},
                                             {0.62, 0.58},
                                             {0.70, 0.20},
                                             {0.76, 0.0}}};
    std::vector<std::vector<Corner>> rows;
    for (const Step& step : kProfile)
    {
        std::vector<Corner>& row = rows.emplace_back();
        for (int s = 0; s <= kSides; ++s)
        {
            const double turn = -2.0 * std::numbers::pi * (s % kSides) / kSides * wheel.outwards;
            const glm::dvec3 place = wheel.hub + glm::dvec3(std::cos(turn) * step.radius * wheel.radiusM,
                                                            wheel.outwards * step.outM * 0.5 * wheel.widthM,
                                                            std::sin(turn) * step.radius * wheel.radiusM);
            const double shown =
                step.outM < 0.9 && step.radius > 0.69 ? 0.97 : step.radius; // the tread shows plain rubber
            row.push_back({place,
                           {static_cast<float>(0.5 + 0.49 * shown * std::cos(turn)),
                            static_cast<float>(0.5 + 0.49 * shown * std::sin(turn))}});
        }
    }
    builder.grid(rows);
}

} // namespace scenery::models
