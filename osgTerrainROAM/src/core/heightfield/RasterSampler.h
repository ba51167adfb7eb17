// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// The heights of a raster at places between its samples, by Catmull and Rom's cubic, which goes through the samples and
/// bends where straight pieces would break; held within the range of the four samples around, so that flat water stays flat
/// and no shore dips below it. Beside voids it is bilinear.
/// Units: places of the raster, metres.
class RasterSampler
{
public:
    explicit RasterSampler(const Raster& raster) : _raster(raster) {}

    /// NaN: a void, or beyond the outermost samples. A place within a thousandth of a sample is that sample's.
    float heightM(glm::dvec2 place) const;

    /// How far a place lies beyond the outermost samples, along a row or a column, in samples; 0 within them.
    double beyond(const glm::dvec2& place) const;

private:
    float sample(int column, int row) const;

    const Raster& _raster;
};

} // namespace osgTerrainROAM::core
