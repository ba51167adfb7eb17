// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/Allard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace scenery
{

namespace
{

using Row = std::pair<double, double>;

/// Straight between the logarithms of the second numbers, level beyond the ends.
template<std::size_t kRows>
double between(const std::array<Row, kRows>& rows, double at)
{
    std::size_t i = 0;
    while (i + 2 < kRows && at > rows[i + 1].first)
        ++i;
    const double share = std::clamp((at - rows[i].first) / (rows[i + 1].first - rows[i].first), 0.0, 1.0);
    return std::exp(std::lerp(std::log(rows[i].second), std::log(rows[i + 1].second), share));
}

} // namespace

double illuminanceLx(double candela, double distanceM, double visibilityM)
{
    return candela * std::exp(-3.0 * distanceM / visibilityM) / (distanceM * distanceM);
}

double leastIlluminanceLx(double backgroundCdM2)
{
    // By the logarithm of the background: 6.85, √(50·999), √(1000·12000) and 30000 cd/m².
    static constexpr std::array<Row, 4> kRows{{{0.836, 8e-7}, {2.349, 1e-5}, {3.540, 1e-4}, {4.477, 1e-3}}};
    return between(kRows, std::log10(std::max(backgroundCdM2, 1e-6)));
}

double backgroundCdM2(double sunElevationDeg, double cloudCover)
{
    static constexpr std::array<Row, 10> kLevelLx{{{-18.0, 6.5e-4},
                                                   {-12.0, 8.3e-3},
                                                   {-8.0, 0.6},
                                                   {-6.0, 3.4},
                                                   {-3.0, 60.0},
                                                   {0.0, 700.0},
                                                   {5.0, 6000.0},
                                                   {15.0, 23000.0},
                                                   {35.0, 66000.0},
                                                   {90.0, 124000.0}}};
    const double overcast = std::lerp(1.0, 0.15, std::clamp(cloudCover, 0.0, 1.0));
    return between(kLevelLx, sunElevationDeg) * overcast / std::numbers::pi;
}

double visibleRangeM(double candela, double visibilityM, double leastLx)
{
    double low = 0.0, high = std::sqrt(candela / leastLx);
    for (int i = 0; i < 60; ++i)
    {
        const double middle = 0.5 * (low + high);
        (illuminanceLx(candela, middle, visibilityM) > leastLx ? low : high) = middle;
    }
    return low;
}

} // namespace scenery
