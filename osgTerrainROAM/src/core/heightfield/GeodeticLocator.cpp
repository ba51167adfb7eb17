// SPDX-License-Identifier: Apache-2.0
#include "GeodeticLocator.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <foundation/Angle.h>

#include "VerticalSystem.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Result;

std::string codeOr(const VerticalSystem& system)
{
    return system.code.empty() ? "'" + system.name + "'"
                               : "EPSG:4326+" + system.code.substr(system.code.find(':') + 1);
}

} // namespace

Result<GeodeticLocator> GeodeticLocator::create(const std::string& name, const Raster& raster,
                                                VerticalDatum datum, GdalSession& gdal)
{
    gdal.clear();
    const ReferenceSystem source(OSRNewSpatialReference(raster.crsWkt.c_str()));
    const ReferenceSystem wgs84(OSRNewSpatialReference(nullptr));
    OSRImportFromEPSG(wgs84.get(), 4326);
    const ReferenceSystem whole(OSRClone(source.get()));
    const VerticalSystem vertical =
        datum == VerticalDatum::automatic ? verticalSystemOf(whole.get()) : VerticalSystem();
    const bool ellipsoidal = datum == VerticalDatum::ellipsoid || vertical.isEllipsoidal;
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
    locator._vertical = vertical.isEllipsoidal ? "" : vertical.name;
    if (ellipsoidal) return locator;

    if (!vertical.isEgm96)
    {
        const glm::dvec2 first(locator._frame.firstX, locator._frame.firstY),
            size((raster.columns - 1) * locator._frame.stepX, (raster.rows - 1) * locator._frame.stepY);
        const std::array<glm::dvec2, 5> places{first, first + size, first + 0.5 * size,
                                               first + glm::dvec2(size.x, 0.0),
                                               first + glm::dvec2(0.0, size.y)};
        locator._shift = VerticalShift::find(whole.get(), places);
        if (!locator._shift)
            gdal.note("its heights above " + vertical.name +
                      " are taken as above EGM96, from which they may differ by a metre or two: PROJ finds "
                      "no grid" +
                      " for them; put the grid that 'projinfo -s " + codeOr(vertical) +
                      " -t EPSG:4979 --spatial-test intersects' names into a folder of PROJ_DATA, or say "
                      "vertical_datum");
    }
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
    std::vector<glm::dvec2> places;
    for (std::size_t i = 0; i < grid.size() && _shift; ++i)
        places.emplace_back(x[i], y[i]);
    std::vector<int> good(grid.size(), FALSE);
    OCTTransformEx(_toWgs84.get(), static_cast<int>(grid.size()), x.data(), y.data(), nullptr, good.data());
    for (std::size_t i = 0; i < grid.size(); ++i)
    {
        const bool valid = good[i] && std::isfinite(x[i]) && std::isfinite(y[i]) && std::abs(y[i]) <= 90.0;
        constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
        nodes[i] = valid ? GeodeticNet::Node{y[i], x[i], 0.0} : GeodeticNet::Node{kNaN, kNaN, kNaN};
    }
    if (_geoid) addGeoid(places, nodes);
}

void GeodeticLocator::addGeoid(std::span<const glm::dvec2> places, std::span<GeodeticNet::Node> nodes) const
{
    std::vector<double> latitudes, longitudes, heights(nodes.size());
    for (const GeodeticNet::Node& node : nodes)
    {
        latitudes.push_back(node.latitudeDeg);
        longitudes.push_back(node.longitudeDeg);
    }
    _geoid->heights(latitudes, longitudes, heights);
    if (_shift) _shift->heights(places, heights);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        nodes[i].geoidM = heights[i];
}

} // namespace osgTerrainROAM::core
