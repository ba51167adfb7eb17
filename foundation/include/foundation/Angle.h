// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
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

/// Brings an angle to within half a turn of 0: -π…π.
inline double wrappedRad(double radians)
{
    return std::remainder(radians, 2.0 * std::numbers::pi);
}

/// Brings an angle to within half a turn of 0: -180…180.
inline double wrappedDeg(double degrees)
{
    return std::remainder(degrees, 360.0);
}

} // namespace foundation
