// SPDX-License-Identifier: Apache-2.0
#include "CellSizeReference.h"

#include <cmath>

#include <ogr_srs_api.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Tells whether a number or its reciprocal is whole to within half a percent.
bool isWholeOrPart(double arcSeconds)
{
    constexpr double kSlack = 0.005;
    const double whole = arcSeconds >= 1.0 - kSlack ? arcSeconds : 1.0 / arcSeconds;
    return std::abs(whole - std::round(whole)) <= kSlack * whole;
}

} // namespace

bool looksLikeDegrees(const GridFrame& frame, int columns, int rows)
{
    constexpr double kLargestCellDeg = 0.05;
    if (frame.stepX > kLargestCellDeg || frame.stepY > kLargestCellDeg) return false;
    if (!isWholeOrPart(3600.0 * frame.stepX) || !isWholeOrPart(3600.0 * frame.stepY)) return false;
    const double lastX = frame.firstX + frame.stepX * (columns - 1);
    const double lastY = frame.firstY + frame.stepY * (rows - 1);
    if (frame.firstX < -360.0 || lastX > 360.0 || frame.firstY < -90.0 || lastY > 90.0) return false;
    const auto startsAtZero = [](double first, double step) { return std::abs(first) <= step; };
    return !(startsAtZero(frame.firstX, frame.stepX) && startsAtZero(frame.firstY, frame.stepY));
}

std::string wgs84Wkt()
{
    return SRS_WKT_WGS84_LAT_LONG;
}

std::optional<double> metresOfPlane(const std::string& crsWkt)
{
    if (crsWkt.empty()) return 1.0;
    const OGRSpatialReferenceH crs = OSRNewSpatialReference(crsWkt.c_str());
    std::optional<double> metres;
    if (OSRIsLocal(crs)) metres = OSRGetLinearUnits(crs, nullptr);
    OSRDestroySpatialReference(crs);
    return metres;
}

} // namespace osgTerrainROAM::core
