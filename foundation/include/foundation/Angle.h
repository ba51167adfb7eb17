// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace foundation
{

/// Converts an angle from degrees to radians.
constexpr double radiansOf(double degrees)
{
    return degrees * (std::numbers::pi / 180.0);
}

/// Converts an angle from radians to degrees.
constexpr double degreesOf(double radians)
{
    return radians * (180.0 / std::numbers::pi);
}

} // namespace foundation
