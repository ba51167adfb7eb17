// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <osgTerrainROAM/core/heightfield/GridRect.h>

#include "MosaicSource.h"

namespace osgTerrainROAM::core
{

/// A rectangle of a terrain that is kept on a finer grid than the rest.
struct PlannedPart
{
    GridRect cells; ///< samples of the terrain's own raster at its corners
    int exponent;   ///< 2^exponent of its samples lie along a cell of that raster
};

/// The plan of the grids on which a terrain joined from several rasters is kept.
struct MosaicPlan
{
    GridReference grid;    ///< of the terrain's own raster: the finest source's, or coarser by 2^exponent
    GridRect rect;         ///< of that grid
    double spacingM = 0.0; ///< of it
    int exponent = 0;      ///< of the finest source's samples to it
    std::vector<PlannedPart> parts; ///< coarse before fine
};

/// Plans one grid for all sources where that is not too large; otherwise a coarser one, and parts around
/// finer rasters.
/// `sources`: coarse before fine. Errors: a source that cannot be related to the others; parts that are too
/// large.
foundation::Result<MosaicPlan> planMosaic(std::span<const MosaicSource> sources, GdalSession& gdal);

/// A grid with 2^exponent times the spacing (a negative exponent: a finer grid) and the same first point.
GridReference scaled(GridReference grid, int exponent);

} // namespace osgTerrainROAM::core
