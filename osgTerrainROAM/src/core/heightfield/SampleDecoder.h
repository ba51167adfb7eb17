// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <gdal.h>

namespace osgTerrainROAM::core
{

/// Turns a band's numbers into metres, by its unit, scale and offset, and what is no height into NaN: its
/// nodata value, NaN, and heights that no place on Earth has.
class SampleDecoder
{
public:
    explicit SampleDecoder(GDALRasterBandH band);

    float heightM(double value);

    std::size_t implausible = 0; ///< heights refused so far for being outside -12000 to 9000 m

private:
    double _noData = 0.0;
    bool _hasNoData = false;
    double _scale = 1.0;
    double _offset = 0.0;
};

} // namespace osgTerrainROAM::core
