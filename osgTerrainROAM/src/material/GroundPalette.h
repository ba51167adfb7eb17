// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include <osg/Vec3f>

#include <osgTerrainROAM/core/cover/CoverTable.h>

#include <osgTerrainROAM/Climate>

namespace osgTerrainROAM
{

/// Albedos of the ground, linear, and what the season does to snow.
struct GroundPalette
{
    osg::Vec3f rock, soil, dryGrass, meadow, forest, sand, snow, water;
    std::array<osg::Vec3f, 4> crops; ///< by core::Crop
    osg::Vec3f fieldSoil;
    float snowShiftM = 0.0f; ///< to the snow line of early summer
};

/// The palette of a climate; of early summer, or of a time of the year: 0 the first of January … 1 the last of December, counted
/// half a year on south of the equator. Leaves, grass and crops change by the month, and with the latitude: within 10° of the
/// equator not at all, from 40° on fully. Keys lie in the middle of each month; between them it is linear. June is early summer.
/// Every number is a matter of looks. Pure.
GroundPalette groundPalette(const Climate& climate, std::optional<double> yearShare);

/// What a kind of ground looks like: its albedo and, in patches, another.
struct KindLook
{
    osg::Vec3f albedo;
    float wood = 0.0f; ///< share of treetops
    osg::Vec3f patch;
    float patches = 0.0f; ///< share of the patches
};
std::array<KindLook, core::kGroundKinds> kindLooks(const GroundPalette& palette);

} // namespace osgTerrainROAM
