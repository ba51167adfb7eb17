// SPDX-License-Identifier: Apache-2.0
#include "MosaicSource.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <GeographicLib/Geodesic.hpp>

#include "CellSizeReference.h"
#include "GeodeticLocator.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Result;

/// The properties of a source besides its samples.
struct Nature
{
    double spacingM;
    bool isEllipsoidal;
    std::string vertical; ///< the system of its heights; empty: it names none
};

Result<Nature> natureOf(const std::string& name, const Raster& raster, const DemImportOptions& options,
                        GdalSession& gdal)
{
    if (const std::optional<double> metres = metresOfPlane(raster.crsWkt))
        return Nature{raster.frame->stepY * *metres, false, {}};
    const auto locator = GeodeticLocator::create(name, raster, options.verticalDatum, gdal);
    if (!locator) return locator.error();
    const glm::dvec2 middle = 0.5 * glm::dvec2(raster.columns - 1, raster.rows - 1);
    const std::array<glm::dvec2, 2> places{middle, middle + glm::dvec2(0.0, 1.0)};
    std::array<GeodeticNet::Node, 2> nodes{};
    locator->locate(places, nodes);
    double metres = 0.0;
    GeographicLib::Geodesic::WGS84().Inverse(nodes[0].latitudeDeg, nodes[0].longitudeDeg,
                                             nodes[1].latitudeDeg, nodes[1].longitudeDeg, metres);
    if (!(metres > 0.0))
        return Error{name, "has samples that lie nowhere, or on top of each other",
                     "check its georeference with gdalinfo"};
    return Nature{metres, locator->isEllipsoidal(), locator->verticalName()};
}

} // namespace

void settleReference(Raster& raster)
{
    if (raster.frame && raster.crsWkt.empty() && looksLikeDegrees(*raster.frame, raster.columns, raster.rows))
        raster.crsWkt = wgs84Wkt();
}

foundation::Outcome checkPlaced(const std::filesystem::path& file, const Raster& raster)
{
    if (raster.frame) return foundation::success();
    return Error{file.string(), "has no georeference: its place among the other rasters is unknown",
                 "assign one with gdal_translate -a_ullr"};
}

Result<std::vector<MosaicSource>> readSources(std::span<const std::filesystem::path> files,
                                              const DemImportOptions& options, GdalSession& gdal)
{
    std::vector<MosaicSource> sources;
    bool isEllipsoidal = false;
    std::string vertical;
    for (const std::filesystem::path& file : files)
    {
        Result<Raster> raster = readRaster(file, gdal);
        if (!raster) return raster.error();
        if (const auto placed = checkPlaced(file, *raster); !placed) return placed.error();
        settleReference(*raster);
        const auto nature = natureOf(file.string(), *raster, options, gdal);
        if (!nature) return nature.error();
        if (!sources.empty() && nature->isEllipsoidal != isEllipsoidal)
            return Error{file.string(),
                         "counts its heights from " +
                             std::string(isEllipsoidal ? "sea level, and those before from the ellipsoid"
                                                       : "the ellipsoid, and those before from sea level"),
                         "convert it with gdalwarp -t_srs and a vertical reference, or say vertical_datum"};
        isEllipsoidal = nature->isEllipsoidal;
        if (vertical.empty()) vertical = nature->vertical;
        if (!nature->vertical.empty() && nature->vertical != vertical)
            gdal.note("its heights count from " + nature->vertical + ", those of files before it from " +
                      vertical + ": they are joined as if from one");
        sources.push_back({file.string(), std::move(*raster), nature->spacingM});
    }
    return sources;
}

} // namespace osgTerrainROAM::core
