// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgSky/SunShadowSettings>

namespace trainer
{

/// How much of a picture's detail is drawn.
enum class Quality : std::uint8_t
{
    low,
    medium,
    high,
    reference ///< finer than anybody needs: what consecutive pictures are compared with
};

/// What a quality leaves out. docs/reference/quality.md tells people the same.
struct QualityRules
{
    double tolerancePx = 1.0; ///< of terrain, roads and single objects, where none was asked for
    double budgetShare = 1.0; ///< of the triangles that a scenery file allows
    int coverReaches = 3;     ///< of what grows around the eye: how many of scenery::kCoverReachesM
    bool hasSkyShade = true;  ///< whether ground below trees, vehicles and walls gets less light of the sky
    double drawnSide = 1.0;   ///< share of the pixels along each side that are drawn (ScaledPicture)
    int pixelsPerRay = 3;     ///< along a side, of the picture of the clouds
    int raySteps = 64;        ///< the most of such a ray
    const char* define = nullptr; ///< of the shaders, for cheaper ones; null: none
    osgSky::SunShadowSettings shadows{.movingMaps = 3};
};

inline QualityRules rulesOf(Quality quality)
{
    switch (quality)
    {
    case Quality::low:
        return {.tolerancePx = 4.0,
                .budgetShare = 0.2,
                .coverReaches = 0,
                .hasSkyShade = false,
                .drawnSide = 0.75,
                .pixelsPerRay = 4,
                .raySteps = 32,
                .define = "PICTURE_LOW",
                .shadows = {{15.0, 60.0, 240.0, 2000.0}, 512, 0.125, 1, false}};
    case Quality::medium:
        return {.tolerancePx = 2.0,
                .budgetShare = 0.4,
                .coverReaches = 1,
                .pixelsPerRay = 3,
                .raySteps = 48,
                .define = "PICTURE_MEDIUM",
                .shadows = {{40.0, 120.0, 480.0, 5000.0}, 1024, 0.125, 1, false}};
    case Quality::reference:
        return {.tolerancePx = 0.1,
                .budgetShare = 40.0,
                .pixelsPerRay = 1,
                .raySteps = 128,
                .shadows = {{20.0, 90.0, 400.0, 5000.0}, 4096}};
    case Quality::high:
        break;
    }
    return {};
}

} // namespace trainer
