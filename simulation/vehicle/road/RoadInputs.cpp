// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/RoadInputs.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

double inputOf(const RoadInputs& inputs, RoadInput input)
{
    constexpr double kMostGears = 32.0;
    const double value = inputs[static_cast<std::size_t>(input)];
    if (std::isnan(value)) return 0.0;
    if (input == RoadInput::gear) return std::round(std::clamp(value, -1.0, kMostGears));
    const bool isTwoSided =
        input == RoadInput::steering || input == RoadInput::indicator || input == RoadInput::lights;
    return std::clamp(value, isTwoSided ? -1.0 : 0.0, 1.0);
}

} // namespace simulation
