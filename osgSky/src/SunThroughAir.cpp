// SPDX-License-Identifier: Apache-2.0
#include "SunThroughAir.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace osgSky
{

namespace
{

constexpr std::array<double, 3> kBandsUm{0.610, 0.550, 0.465};
constexpr std::array<double, 3> kOzonePerCm{0.120, 0.085, 0.008};
constexpr double kOzoneCm = 0.30; ///< of a mean column, at sea level's pressure

/// The optical depth of the air's molecules above sea level.
double rayleighDepth(double waveUm)
{
    const double w2 = waveUm * waveUm;
    return 1.0 / (w2 * w2 * (115.6406 - 1.335 / w2));
}

} // namespace

double airMass(double elevationDeg)
{
    const double elevation = std::max(elevationDeg, 0.0);
    const double sine = std::sin(elevation * 3.14159265358979323846 / 180.0);
    return 1.0 / (sine + 0.50572 * std::pow(elevation + 6.07995, -1.6364));
}

osg::Vec3f sunThroughAir(double elevationDeg, const osg::Vec3f& haze)
{
    const double way = airMass(elevationDeg);
    osg::Vec3f share;
    for (int i = 0; i < 3; ++i)
    {
        const auto band = static_cast<std::size_t>(i);
        const double depth = rayleighDepth(kBandsUm[band]) + kOzonePerCm[band] * kOzoneCm + haze[i];
        share[i] = static_cast<float>(std::exp(-depth * way));
    }
    return share;
}

} // namespace osgSky
