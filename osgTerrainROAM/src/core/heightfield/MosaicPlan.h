// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <osgTerrainROAM/core/heightfield/GridRect.h>

#include "MosaicSource.h"

namespace osgTerrainROAM::core
{

/// A rectangle of a terrain that is kept more finely than the rest.
struct PlannedPart
{
    GridRect cells; ///< samples of the terrain's own raster at its corners
    int exponent;   ///< 2^exponent of its samples to one of those
};

/// How a terrain is kept that is joined from several rasters.
struct MosaicPlan
{
    GridReference grid;    ///< of the terrain's own raster: the finest source's, or coarser by 2^exponent
    GridRect rect;         ///< of that grid
    double spacingM = 0.0; ///< of it
    int exponent = 0;      ///< of the finest source's samples to it
    std::vector<PlannedPart> parts; ///< coarse before fine
};

/// One grid for all where it does not get too large; else a coarser one, and parts around finer rasters.
/// `sources`: coarse before fine. Errors: a source without a place among the others; parts that get too large.
foundation::Result<MosaicPlan> planMosaic(std::span<const MosaicSource> sources, GdalSession& gdal);

/// A grid whose places lie 2^exponent times as far apart (a negative exponent: closer), with the same first place.
GridReference scaled(GridReference grid, int exponent);

} // namespace osgTerrainROAM::core
