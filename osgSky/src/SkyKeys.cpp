// SPDX-License-Identifier: Apache-2.0
#include "SkyKeys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <osgSky/MixedColour>

namespace osgSky
{

namespace
{

// Colours chosen by eye against photographs: blue by day, warm at the horizon, steel-blue dusk, dark but not
// black night. Up to 15 degrees strengths are such that displayColour() of the sky rises evenly with the sun.
constexpr std::size_t kKeys = 14;
constexpr double kEvenDeg = 15.0;
const std::array<SkyKey, kKeys>& skyKeys()
{
    static const std::array<SkyKey, kKeys> keys{{
        {-20.0, {0.0030f, 0.0044f, 0.0103f}, {0.0059f, 0.0079f, 0.0158f}, {0.0f, 0.0f, 0.0f}},
        {-17.0, {0.0060f, 0.0094f, 0.0221f}, {0.0145f, 0.0183f, 0.0323f}, {0.004f, 0.002f, 0.002f}},
        {-13.0, {0.0112f, 0.0187f, 0.0440f}, {0.0327f, 0.0396f, 0.0624f}, {0.020f, 0.010f, 0.010f}},
        {-8.0, {0.0201f, 0.0342f, 0.0805f}, {0.0644f, 0.0772f, 0.1180f}, {0.040f, 0.020f, 0.020f}},
        {-5.0, {0.0276f, 0.0459f, 0.0972f}, {0.1072f, 0.1029f, 0.1263f}, {0.226f, 0.098f, 0.056f}},
        {-2.0, {0.0356f, 0.0591f, 0.1231f}, {0.1521f, 0.1349f, 0.1464f}, {0.550f, 0.250f, 0.113f}},
        {0.0, {0.0413f, 0.0688f, 0.1444f}, {0.1871f, 0.1594f, 0.1594f}, {0.950f, 0.450f, 0.180f}},
        {5.0, {0.0536f, 0.1005f, 0.2143f}, {0.2478f, 0.2478f, 0.2655f}, {1.100f, 0.720f, 0.380f}},
        {10.0, {0.0693f, 0.1386f, 0.3017f}, {0.3373f, 0.3673f, 0.4198f}, {1.050f, 0.800f, 0.530f}},
        {12.5, {0.0774f, 0.1592f, 0.3494f}, {0.3918f, 0.4424f, 0.5182f}, {1.025f, 0.840f, 0.605f}},
        {14.0, {0.0831f, 0.1736f, 0.3827f}, {0.4335f, 0.4993f, 0.5926f}, {1.010f, 0.864f, 0.650f}},
        {kEvenDeg, {0.090f, 0.190f, 0.420f}, {0.480f, 0.560f, 0.670f}, {1.00f, 0.88f, 0.68f}},
        {35.0, {0.095f, 0.215f, 0.490f}, {0.510f, 0.640f, 0.800f}, {0.90f, 0.88f, 0.80f}},
        {90.0, {0.100f, 0.225f, 0.510f}, {0.520f, 0.660f, 0.830f}, {0.90f, 0.90f, 0.85f}},
    }};
    return keys;
}

/// Between the roots of two colours: evenly on a screen, which shows roots.
osg::Vec3f rootsMixed(const osg::Vec3f& a, const osg::Vec3f& b, float share)
{
    osg::Vec3f mean;
    for (int i = 0; i < 3; ++i)
    {
        const float root = std::sqrt(a[i]) + (std::sqrt(b[i]) - std::sqrt(a[i])) * share;
        mean[i] = root * root;
    }
    return mean;
}

} // namespace

SkyKey skyAt(double elevationDeg)
{
    const auto& keys = skyKeys();
    const double e = std::clamp(elevationDeg, keys.front().elevationDeg, keys.back().elevationDeg);
    std::size_t i = 0;
    while (i < kKeys - 2 && e > keys[i + 1].elevationDeg)
        ++i;
    const SkyKey &from = keys[i], &to = keys[i + 1];
    const auto share = static_cast<float>((e - from.elevationDeg) / (to.elevationDeg - from.elevationDeg));
    const auto between = to.elevationDeg > kEvenDeg ? &mixed : &rootsMixed;
    return {e, between(from.zenith, to.zenith, share), between(from.horizon, to.horizon, share),
            between(from.glow, to.glow, share)};
}

} // namespace osgSky
