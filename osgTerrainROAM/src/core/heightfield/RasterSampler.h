// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// Interpolates a raster's heights by the Catmull-Rom cubic, clamped to the range of the four samples around
/// the point: flat water stays flat, and no shore dips below it. Beside voids it is bilinear.
/// Units: columns and rows of the raster, metres.
/// Source: Catmull & Rom, *A Class of Local Interpolating Splines*, 1974; the clamp is ours.
class RasterSampler
{
public:
    explicit RasterSampler(const Raster& raster) : _raster(raster) {}

    /// Height at (column, row); NaN in a void, or beyond the outermost samples. Within a thousandth of a step
    /// of a sample, its height.
    float heightM(glm::dvec2 place) const;

    /// Distance beyond the outermost samples, along a row or a column, in sample steps; 0 within them.
    double beyond(const glm::dvec2& place) const;

private:
    float sample(int column, int row) const;

    const Raster& _raster;
};

} // namespace osgTerrainROAM::core
