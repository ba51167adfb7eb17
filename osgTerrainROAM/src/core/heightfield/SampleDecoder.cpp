// SPDX-License-Identifier: Apache-2.0
#include "SampleDecoder.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kLowestM = -12000.0; ///< the Challenger Deep lies at -10935 m
constexpr double kHighestM = 9000.0;  ///< Mount Everest at 8849 m

/// Metres per unit of the band's heights.
double metresPerUnit(GDALRasterBandH band)
{
    std::string unit = GDALGetRasterUnitType(band);
    std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::tolower(c); });
    if (unit == "ft" || unit == "foot" || unit == "feet") return 0.3048;
    if (unit == "us-ft" || unit == "us survey foot" || unit == "ft_us" || unit == "foot_us")
        return 1200.0 / 3937.0;
    if (unit == "cm") return 0.01;
    if (unit == "km") return 1000.0;
    return 1.0;
}

} // namespace

SampleDecoder::SampleDecoder(GDALRasterBandH band)
{
    int has = FALSE;
    _noData = GDALGetRasterNoDataValue(band, &has);
    _hasNoData = has != FALSE;
    const double scale = GDALGetRasterScale(band, &has);
    const double offset = GDALGetRasterOffset(band, &has);
    const double metres = metresPerUnit(band);
    _scale = (scale == 0.0 ? 1.0 : scale) * metres;
    _offset = offset * metres;
}

float SampleDecoder::heightM(double value)
{
    constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();
    if (std::isnan(value)) return kVoid;
    // As floats, because 1.70141e38 and its like are written shorter than they are stored.
    if (_hasNoData && (value == _noData || static_cast<float>(value) == static_cast<float>(_noData)))
        return kVoid;
    const double metres = value * _scale + _offset;
    if (metres >= kLowestM && metres <= kHighestM) return static_cast<float>(metres);
    ++implausible;
    return kVoid;
}

} // namespace osgTerrainROAM::core
