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

/// Where the outermost samples of a raster lie on a grid. Errors: it has no place there.
foundation::Result<GridRect> rectOn(const GridReference& grid, const MosaicSource& source, GdalSession& gdal);

/// A raster on a grid.
struct LaidRaster
{
    GridRect rect;
    double spacingM;
};

/// How far apart the samples are that a raster over `rect` meets along its outline: those of the finest of the others that it lies
/// within, or else the widest. 0: there are no others.
double spacingBelow(std::span<const LaidRaster> laid, const GridRect& rect);

/// Whether a raster is so much finer than a grid that it only shows through at every so many samples; metres.
inline bool isFinerThanGrid(double rasterM, double gridM)
{
    return rasterM < 0.75 * gridM;
}

/// Places of a grid over which ground is bent towards a finer raster; all metres.
int bendingReach(double gridM, double rasterM, double belowM);

/// A part of a grid that rasters are laid on, coarse ones before fine ones.
/// Invariant: what has been laid is there as measured, but where it has been bent towards what was laid later.
class MosaicCanvas
{
public:
    /// `spacingM`: of the grid; `coarsestM`: of the coarsest raster that will be laid.
    MosaicCanvas(const GridReference& grid, const GridRect& rect, double spacingM, double coarsestM);

    /// Lays a raster over what is there. Errors: it has no place on the grid.
    foundation::Outcome add(const MosaicSource& source, GdalSession& gdal, MosaicReport& report);

    /// What has been laid: heights, frame, isOutside.
    Raster take() &&;

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
    const double _coarsestStep; ///< places to a sample
    std::vector<Reach> _reach;
    std::vector<float> _beyond; ///< the pixels of the raster that comes nearest, places
    std::vector<LaidRaster> _laid;
};

} // namespace osgTerrainROAM::core
