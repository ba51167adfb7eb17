// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/GridRect.h>

#include "MosaicSource.h"
#include "SeamBend.h"

namespace osgTerrainROAM::core
{

/// The bounding rectangle of a raster's samples on a grid. Errors: the raster cannot be located on the grid.
foundation::Result<GridRect> rectOn(const GridReference& grid, const MosaicSource& source, GdalSession& gdal);

/// A raster on a grid.
struct LaidRaster
{
    GridRect rect;
    double spacingM;
};

/// The sample spacing that a raster over `rect` meets along its outline: that of the finest other raster that
/// contains it, or else the widest. 0: there are no others.
double spacingBelow(std::span<const LaidRaster> laid, const GridRect& rect);

/// Tells whether a raster is so much finer than a grid that only every n-th of its samples is used; metres.
inline bool isFinerThanGrid(double rasterM, double gridM)
{
    return rasterM < 0.75 * gridM;
}

/// The number of grid points over which ground is bent towards a finer raster; arguments in metres.
int bendingReach(double gridM, double rasterM, double belowM);

/// A rectangle of a grid on which rasters are laid, coarse before fine.
/// Invariant: heights are as measured, except where they have been bent towards a raster laid later.
class MosaicCanvas
{
public:
    /// `spacingM`: of the grid; `coarsestM`: of the coarsest raster that will be laid.
    MosaicCanvas(const GridReference& grid, const GridRect& rect, double spacingM, double coarsestM);

    /// Lays a raster over the present heights. Errors: the raster cannot be located on the grid.
    foundation::Outcome add(const MosaicSource& source, GdalSession& gdal, MosaicReport& report);

    /// The result: heights, frame, isOutside.
    Raster release() &&;

private:
    enum class Reach : std::uint8_t
    {
        none,
        between, ///< in a gap that is no wider than the samples beside it stand apart
        inside,  ///< of a raster's outermost samples
    };

    void sampleInto(HeightSheet& sheet, const Raster& raster, const FrameTransform& transform,
                    double stepPlaces);
    void mark(int column, int row, double beyond, double stepPlaces);

    GridReference _grid;
    HeightSheet _ground;
    const double _spacingM;
    const double _coarsestStep; ///< grid points to a sample
    std::vector<Reach> _reach;
    std::vector<float> _beyond; ///< distance to the nearest raster's pixels, grid points
    std::vector<LaidRaster> _laid;
};

} // namespace osgTerrainROAM::core
