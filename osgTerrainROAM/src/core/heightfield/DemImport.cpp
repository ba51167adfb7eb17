// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "CellSizeReference.h"
#include "GeodeticLocator.h"
#include "GeodeticNetBuilder.h"
#include "RasterFile.h"
#include "VoidFill.h"

namespace osgTerrainROAM::core
{

namespace
{

using viewlod::Error;
using viewlod::Outcome;
using viewlod::Result;

/// Gives the field its place: on the Earth where the raster says where that is, else a plane.
Outcome place(HeightField& field, Raster& raster, const DemImportOptions& options, GdalSession& gdal)
{
    if (!raster.frame)
    {
        if (!options.spacingM)
            return Error{field.name, "has no georeference",
                         "state the distance between its samples with --spacing METRES"};
        if (!std::isfinite(*options.spacingM) || *options.spacingM <= 0.0)
            return Error{field.name, "cannot have samples " + std::to_string(*options.spacingM) + " m apart",
                         "give --spacing the metres between samples"};
        field.spacingEastM = field.spacingNorthM = *options.spacingM;
        return viewlod::success();
    }
    if (raster.crsWkt.empty() && looksLikeDegrees(*raster.frame, raster.columns, raster.rows))
        raster.crsWkt = wgs84Wkt();
    if (const std::optional<double> metres = metresOfPlane(raster.crsWkt))
    {
        field.spacingEastM = raster.frame->stepX * *metres;
        field.spacingNorthM = raster.frame->stepY * *metres;
        return viewlod::success();
    }
    const Result<GeodeticLocator> locator =
        GeodeticLocator::create(field.name, raster, options.verticalDatum, gdal);
    if (!locator) return locator.error();
    return georeference(field, *locator);
}

Result<HeightField> import(const std::filesystem::path& file, const DemImportOptions& options)
{
    GdalSession gdal;
    Result<Raster> raster = readRaster(file, gdal);
    if (!raster) return raster.error();

    HeightField field;
    field.name = file.string();
    field.columns = raster->columns;
    field.rows = raster->rows;
    if (const Outcome placed = place(field, *raster, options, gdal); !placed) return placed.error();

    field.heightsM = std::move(raster->heightsM);
    if (std::none_of(field.heightsM.begin(), field.heightsM.end(), [](float h) { return std::isfinite(h); }))
        return Error{field.name,
                     "holds no height: every sample is void" +
                         (raster->implausible ? ", or outside -12000 to 9000 m" : std::string()),
                     "check its nodata value and units with gdalinfo"};
    field.voids = fillVoids(field.heightsM, field.columns, field.rows);
    if (raster->implausible)
        field.voids.method +=
            "; " + std::to_string(raster->implausible) + " of them for heights outside -12000 to 9000 m";
    return field;
}

} // namespace

Result<HeightField> importDem(const std::filesystem::path& file, const DemImportOptions& options)
{
    try
    {
        return import(file, options);
    }
    catch (const std::bad_alloc&)
    {
        return Error{file.string(), "does not fit into memory", "cut a part out with gdal_translate -srcwin"};
    }
}

} // namespace osgTerrainROAM::core
