// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgTerrainROAM/SunShadows>

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
    double tolerancePx; ///< of terrain, roads and single objects, where none was asked for
    double budgetShare; ///< of the triangles that a scenery file allows
    int coverReaches;   ///< of what grows around the eye: how many of scenery::kCoverReachesM
    bool hasSkyShade;   ///< whether ground below trees, vehicles and walls gets less light of the sky
    const char* define; ///< of the shaders, for cheaper ones; null: none
    osgTerrainROAM::SunShadowSettings shadows;
};

inline QualityRules rulesOf(Quality quality)
{
    switch (quality)
    {
    case Quality::low:
        return {4.0, 0.2, 0, false, "PICTURE_LOW", {{15.0, 60.0, 240.0, 2000.0}, 512, 0.125, 1, false}};
    case Quality::medium:
        return {2.0, 0.4, 1, true, "PICTURE_MEDIUM", {{40.0, 120.0, 480.0, 5000.0}, 1024, 0.125, 1, false}};
    case Quality::reference:
        return {0.1, 40.0, 3, true, nullptr, {{20.0, 90.0, 400.0, 5000.0}, 4096}};
    case Quality::high:
        break;
    }
    return {1.0, 1.0, 3, true, nullptr, {.movingMaps = 3}};
}

} // namespace trainer
