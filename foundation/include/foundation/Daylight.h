// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace foundation
{

/// Looks up in rows of two numbers, of which the first grows: straight between the logarithms of the second,
/// level beyond the ends.
template<std::size_t kRows>
double betweenLogarithms(const std::array<std::pair<double, double>, kRows>& rows, double at)
{
    std::size_t i = 0;
    while (i + 2 < kRows && at > rows[i + 1].first)
        ++i;
    const double share = std::clamp((at - rows[i].first) / (rows[i + 1].first - rows[i].first), 0.0, 1.0);
    return std::exp(std::lerp(std::log(rows[i].second), std::log(rows[i + 1].second), share));
}

/// The illuminance of level ground by sun and clear sky, in lux, for the height of the sun in degrees.
/// Source: Bond and Henderson, *The conspicuity of flags …* (1963).
inline double daylightLx(double sunElevationDeg)
{
    static constexpr std::array<std::pair<double, double>, 10> kLevelLx{{{-18.0, 6.5e-4},
                                                                         {-12.0, 8.3e-3},
                                                                         {-8.0, 0.6},
                                                                         {-6.0, 3.4},
                                                                         {-3.0, 60.0},
                                                                         {0.0, 700.0},
                                                                         {5.0, 6000.0},
                                                                         {15.0, 23000.0},
                                                                         {35.0, 66000.0},
                                                                         {90.0, 124000.0}}};
    return betweenLogarithms(kLevelLx, sunElevationDeg);
}

} // namespace foundation
