// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include <osg/Vec3f>

#include <osgTerrainROAM/core/cover/CoverTable.h>

#include <osgTerrainROAM/Climate>

namespace osgTerrainROAM
{

/// Linear albedos of the ground, and the season's shift of the snow line.
struct GroundPalette
{
    osg::Vec3f rock, soil, dryGrass, meadow, forest, sand, snow, water;
    std::array<osg::Vec3f, 4> crops; ///< by core::Crop
    osg::Vec3f fieldSoil;
    float snowShiftM = 0.0f; ///< added to the snow line of early summer
};

/// The palette of a climate at a time of the year: 0 is the first of January, 1 the last of December, half a
/// year later south of the equator; without a time it is early summer (June). Leaves, grass and crops change
/// by the month, linearly between the middles of months: fully from 40° of latitude on, not at all within 10°
/// of the equator. All numbers were chosen by eye. Pure.
GroundPalette groundPalette(const Climate& climate, std::optional<double> yearShare);

/// The look of a class of ground: one albedo, and another one in patches.
struct KindLook
{
    osg::Vec3f albedo;
    float wood = 0.0f; ///< share of treetops
    osg::Vec3f patch;
    float patches = 0.0f; ///< share of the patches
};
std::array<KindLook, core::kGroundKinds> kindLooks(const GroundPalette& palette);

} // namespace osgTerrainROAM
