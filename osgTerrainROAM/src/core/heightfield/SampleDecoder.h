// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "GdalSession.h"
#include "RasterSource.h"

namespace osgTerrainROAM::core
{

/// Converts a band's numbers to metres above its zero, by the unit that it or its vertical axis names, and by
/// its scale and offset; depths to negative heights. Values that are no heights become NaN: the nodata value,
/// NaN, and heights outside the Earth's range.
class SampleDecoder
{
public:
    /// `gdal`: gets a note of a unit that is not known, and of depths.
    SampleDecoder(const RasterSource& source, GdalSession& gdal);

    float heightM(double value);

    std::size_t implausible = 0; ///< heights refused so far because they are outside -12000 to 9000 m

private:
    double _noData = 0.0;
    bool _hasNoData = false;
    double _scale = 1.0;
    double _offset = 0.0;
};

} // namespace osgTerrainROAM::core
