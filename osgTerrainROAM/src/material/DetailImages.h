// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <foundation/KeptFrom.h>

#include <osg/Image>
#include <osg/Texture2DArray>
#include <osg/ref_ptr>

namespace osgTerrainROAM
{

/// The surfaces that the ground has within some metres of the eye, in the order of the layers of
/// `terrainDetail`.
enum class Detail
{
    grass, ///< blades and their tips
    stones,
    earth, ///< clods, with a few stones
    rock,  ///< ledges and cracks
    snow,
    litter, ///< leaves and twigs
};
constexpr int kDetails = 6;

/// A square of ground that repeats every kDetailPeriodM metres: red and green: slopes along x and y, blue:
/// height, alpha: brightness, each ½ in the mean. Painted by stamping some thousand bodies (blades, stones,
/// leaves) on noise; the higher one wins. The same bytes everywhere. Slopes are in steps of kDetailSlope;
/// heights in 0 … kDetailHeightM. Cost: some 10 ms.
constexpr int kDetailSide = 256; ///< texels of 5 mm
constexpr double kDetailPeriodM = 1.28;
constexpr double kDetailSlope = 2.0;    ///< the slope that ½ stands for
constexpr double kDetailHeightM = 0.06; ///< from the lowest to the highest
osg::ref_ptr<osg::Image> detailImage(Detail detail);

/// All of them as one texture with mip levels.
osg::ref_ptr<osg::Texture2DArray> detailTexture(const foundation::KeptFrom& kept);

} // namespace osgTerrainROAM
