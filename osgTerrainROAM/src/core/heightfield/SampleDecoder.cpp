// SPDX-License-Identifier: Apache-2.0
#include "SampleDecoder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include <foundation/SmallLetters.h>

#include "VerticalSystem.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kLowestM = -12000.0; ///< the Challenger Deep lies at -10935 m
constexpr double kHighestM = 9000.0;  ///< Mount Everest at 8849 m

struct Unit
{
    std::string_view name; ///< lower case
    double metres;
};

constexpr double kFootM = 0.3048, kSurveyFootM = 1200.0 / 3937.0;
constexpr std::array kUnits = {
    Unit{"", 1.0},
    Unit{"m", 1.0},
    Unit{"metre", 1.0},
    Unit{"metres", 1.0},
    Unit{"meter", 1.0},
    Unit{"meters", 1.0},
    Unit{"mm", 0.001},
    Unit{"cm", 0.01},
    Unit{"centimetre", 0.01},
    Unit{"centimeter", 0.01},
    Unit{"centimetres", 0.01},
    Unit{"centimeters", 0.01},
    Unit{"dm", 0.1},
    Unit{"decimetre", 0.1},
    Unit{"decimeter", 0.1},
    Unit{"decimetres", 0.1},
    Unit{"decimeters", 0.1},
    Unit{"km", 1000.0},
    Unit{"kilometre", 1000.0},
    Unit{"kilometer", 1000.0},
    Unit{"ft", kFootM},
    Unit{"foot", kFootM},
    Unit{"feet", kFootM},
    Unit{"international foot", kFootM},
    Unit{"us-ft", kSurveyFootM},
    Unit{"us survey foot", kSurveyFootM},
    Unit{"us survey feet", kSurveyFootM},
    Unit{"ft_us", kSurveyFootM},
    Unit{"foot_us", kSurveyFootM},
    Unit{"ftus", kSurveyFootM},
    Unit{"yd", 3.0 * kFootM},
    Unit{"yard", 3.0 * kFootM},
    Unit{"fathom", 6.0 * kFootM},
    Unit{"fathoms", 6.0 * kFootM},
};

/// Metres per unit of the band's heights: of the unit that the band names, else of the vertical axis. Absent:
/// a unit that is not known, whose axis does not say how long it is either.
std::optional<double> metresPerUnit(const RasterSource& source, const VerticalSystem& vertical)
{
    const std::string unit = foundation::inSmallLetters(GDALGetRasterUnitType(source.band()));
    const auto known =
        std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& each) { return each.name == unit; });
    if (known != kUnits.end() && !unit.empty()) return known->metres;
    if (vertical.metresPerUnit > 0.0) return vertical.metresPerUnit;
    return unit.empty() ? std::optional(1.0) : std::nullopt;
}

VerticalSystem systemOf(const RasterSource& source)
{
    const OGRSpatialReferenceH crs = GDALGetSpatialRef(source.dataset.get());
    return crs ? verticalSystemOf(crs) : VerticalSystem();
}

} // namespace

SampleDecoder::SampleDecoder(const RasterSource& source, GdalSession& gdal)
{
    const GDALRasterBandH band = source.band();
    const VerticalSystem vertical = systemOf(source);
    const std::optional<double> perUnit = metresPerUnit(source, vertical);
    if (!perUnit)
        gdal.note(std::string("its heights are in '") + GDALGetRasterUnitType(band) +
                  "', a unit that is not known: taken as metres");
    if (vertical.isDepth)
        gdal.note("it counts depths downwards (" + vertical.name + "): heights are their negatives");
    int has = FALSE;
    _noData = GDALGetRasterNoDataValue(band, &has);
    _hasNoData = has != FALSE;
    const double scale = GDALGetRasterScale(band, &has);
    const double offset = GDALGetRasterOffset(band, &has);
    const double metres = perUnit.value_or(1.0) * (vertical.isDepth ? -1.0 : 1.0);
    _scale = (scale == 0.0 ? 1.0 : scale) * metres;
    _offset = offset * metres;
}

float SampleDecoder::heightM(double value)
{
    constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
    if (std::isnan(value)) return kMissing;
    // As floats, because 1.70141e38 and its like are written shorter than they are stored.
    if (_hasNoData && (value == _noData || static_cast<float>(value) == static_cast<float>(_noData)))
        return kMissing;
    const double metres = value * _scale + _offset;
    if (metres >= kLowestM && metres <= kHighestM) return static_cast<float>(metres);
    ++implausible;
    return kMissing;
}

} // namespace osgTerrainROAM::core
