// SPDX-License-Identifier: Apache-2.0
#include "GeodeticLocator.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include <foundation/Angle.h>

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Result;

bool namesEllipsoid(const char* text)
{
    if (!text) return false;
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    return lower.find("ellipsoid") != std::string::npos;
}

bool heightsAreEllipsoidal(OGRSpatialReferenceH crs)
{
    if (!OSRIsCompound(crs)) return OSRGetAxesCount(crs) == 3;
    constexpr const char* kEllipsoidalDatum = "2002"; // datum type of OGC 01-009
    const char* type = OSRGetAttrValue(crs, "VERT_DATUM", 1);
    return (type && std::string(type) == kEllipsoidalDatum) ||
           namesEllipsoid(OSRGetAttrValue(crs, "VERT_CS", 0)) ||
           namesEllipsoid(OSRGetAttrValue(crs, "VERT_DATUM", 0));
}

} // namespace

Result<GeodeticLocator> GeodeticLocator::create(const std::string& name, const Raster& raster,
                                                VerticalDatum datum, GdalSession& gdal)
{
    gdal.clear();
    const ReferenceSystem source(OSRNewSpatialReference(raster.crsWkt.c_str()));
    const ReferenceSystem wgs84(OSRNewSpatialReference(nullptr));
    OSRImportFromEPSG(wgs84.get(), 4326);
    const bool ellipsoidal = datum == VerticalDatum::ellipsoid ||
                             (datum == VerticalDatum::automatic && heightsAreEllipsoidal(source.get()));
    makeHorizontal(source.get());
    OSRSetAxisMappingStrategy(wgs84.get(), OAMS_TRADITIONAL_GIS_ORDER);

    GeodeticLocator locator;
    locator._frame = *raster.frame;
    locator._inDegrees =
        OSRIsGeographic(source.get()) &&
        std::abs(OSRGetAngularUnits(source.get(), nullptr) / foundation::radiansOf(1.0) - 1.0) < 1e-6;
    locator._toWgs84.reset(OCTNewCoordinateTransformation(source.get(), wgs84.get()));
    if (!locator._toWgs84)
        return Error{name, "has coordinates that cannot be related to WGS84 (" + gdal.firstError() + ")",
                     "reproject it with gdalwarp -t_srs EPSG:4326"};
    if (ellipsoidal) return locator;

    locator._geoid = foundation::Geoid::open();
    if (!locator._geoid)
        return Error{name, "has heights above EGM96, whose grid egm96_15.gtx PROJ does not find",
                     "install Debian's proj-data, or say that the heights are ellipsoidal"};
    return locator;
}

void GeodeticLocator::locate(std::span<const glm::dvec2> grid, std::span<GeodeticNet::Node> nodes) const
{
    std::vector<double> x(grid.size()), y(grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i)
    {
        x[i] = _frame.firstX + grid[i].x * _frame.stepX;
        y[i] = _frame.firstY + grid[i].y * _frame.stepY;
        if (!_inDegrees || std::abs(y[i]) <= 90.0) continue;
        y[i] = std::copysign(180.0, y[i]) - y[i];
        x[i] += 180.0;
    }
    std::vector<int> good(grid.size(), FALSE);
    OCTTransformEx(_toWgs84.get(), static_cast<int>(grid.size()), x.data(), y.data(), nullptr, good.data());
    for (std::size_t i = 0; i < grid.size(); ++i)
    {
        const bool valid = good[i] && std::isfinite(x[i]) && std::isfinite(y[i]) && std::abs(y[i]) <= 90.0;
        constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
        nodes[i] = valid ? GeodeticNet::Node{y[i], x[i], 0.0} : GeodeticNet::Node{kNaN, kNaN, kNaN};
    }
    if (_geoid) addGeoid(nodes);
}

void GeodeticLocator::addGeoid(std::span<GeodeticNet::Node> nodes) const
{
    std::vector<double> latitudes, longitudes, heights(nodes.size());
    for (const GeodeticNet::Node& node : nodes)
    {
        latitudes.push_back(node.latitudeDeg);
        longitudes.push_back(node.longitudeDeg);
    }
    _geoid->heights(latitudes, longitudes, heights);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        nodes[i].geoidM = heights[i];
}

} // namespace osgTerrainROAM::core
