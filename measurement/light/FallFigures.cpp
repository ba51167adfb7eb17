// SPDX-License-Identifier: Apache-2.0
#include "measurement/light/FallFigures.h"

namespace measurement
{

namespace
{

/// How many of 200 steps from 0 to `last` make a value not go in its `sense`: 1 up, -1 down.
int wrongSteps(const std::function<double(double)>& valueAt, double last, int sense)
{
    constexpr int kSteps = 200;
    int wrong = 0;
    double before = valueAt(0.0);
    for (int i = 1; i <= kSteps; ++i)
    {
        const double now = valueAt(last * i / kSteps);
        wrong += sense * (now - before) > 0.0 ? 0 : 1; // nor does one without a number
        before = now;
    }
    return wrong;
}

} // namespace

LightFigures fallFigures(const FallParts& parts)
{
    constexpr double kClearM = 60000.0, kRainMm = 100.0, kSnowMm = 10.0, kWaterMm = 2.0;
    const auto inRain = [&](double mm) { return parts.visibilityM(kClearM, parts.rain(mm)); };
    const auto inSnow = [&](double mm) { return parts.visibilityM(kClearM, parts.snow(mm)); };
    return {atMost("N9", "rain to 100 mm/h: steps that clear the air", wrongSteps(inRain, kRainMm, -1), "",
                   0.0, "more of it hides more"),
            atMost("N9", "snow to 10 mm/h: steps that clear the air", wrongSteps(inSnow, kSnowMm, -1), "",
                   0.0, "more of it hides more"),
            atMost("N9", "water to 2 mm: steps that dry the ground", wrongSteps(parts.wetness, kWaterMm, 1),
                   "", 0.0, "more of it is wetter")};
}

} // namespace measurement
