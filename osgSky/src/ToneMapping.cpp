// SPDX-License-Identifier: Apache-2.0
// From light to the screen: exposure, and the curve of displayColour(), which shaders/Atmosphere.glsl has
// once more.
// Sources: ISO 2720, Photography - exposure meters (1974): a meter's reading becomes a medium grey; Dickerson
// and Zawadzki, Do light meters see the world as 18 % gray? (2008): an outdoor scene reflects 12.4 % in the
// mean; Stokes et al., A standard default color space for the Internet: sRGB (1996): a picture that is viewed
// at home has 1.125 times the contrast of what it shows.
#include <algorithm>
#include <cmath>

#include <osgSky/Atmosphere>

namespace osgSky
{

namespace
{

constexpr float kDayExposure = 1.17f;   ///< 12.4 % in full sun is shown as 118 of 255
constexpr float kDayIrradiance = 1.95f; ///< of level ground, the sun 60 degrees high
constexpr float kAdaptation = 0.5f;     ///< 0: one exposure for all; 1: every scene equally bright
constexpr float kMostAdaptation = 2.0f;

} // namespace

float exposureOf(float irradiance)
{
    const float darker = kDayIrradiance / std::max(irradiance, 1e-4f);
    return kDayExposure * std::clamp(std::pow(darker, kAdaptation), 1.0f, kMostAdaptation);
}

osg::Vec3f displayColour(const osg::Vec3f& linear, float exposure)
{
    const auto channel = [exposure](float x)
    {
        const float exposed = std::max(exposure * x, 0.0f);
        const float contrast = exposed * std::sqrt(std::sqrt(std::sqrt(exposed))); // to the power of 1.125
        return std::sqrt(1.0f - std::exp(-contrast));
    };
    return {channel(linear.x()), channel(linear.y()), channel(linear.z())};
}

} // namespace osgSky
