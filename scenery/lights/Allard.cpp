// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/Allard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <foundation/Daylight.h>

namespace scenery
{

namespace
{

using Row = std::pair<double, double>;

} // namespace

double illuminanceLx(double candela, double distanceM, double visibilityM)
{
    return candela * std::exp(-3.0 * distanceM / visibilityM) / (distanceM * distanceM);
}

double leastIlluminanceLx(double backgroundCdM2)
{
    // By the logarithm of the background: 6.85, √(50·999), √(1000·12000) and 30000 cd/m².
    static constexpr std::array<Row, 4> kRows{{{0.836, 8e-7}, {2.349, 1e-5}, {3.540, 1e-4}, {4.477, 1e-3}}};
    return foundation::betweenLogarithms(kRows, std::log10(std::max(backgroundCdM2, 1e-6)));
}

double backgroundCdM2(double sunElevationDeg, double cloudCover)
{
    const double overcast = std::lerp(1.0, 0.15, std::clamp(cloudCover, 0.0, 1.0));
    return foundation::daylightLx(sunElevationDeg) * overcast / std::numbers::pi;
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
