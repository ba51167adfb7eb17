// SPDX-License-Identifier: Apache-2.0
#include "RasterFile.h"

#include <algorithm>
#include <limits>

#include <gdal.h>

#include "GrassNulls.h"
#include "RasterOrientation.h"
#include "RasterSource.h"
#include "SampleDecoder.h"
#include "TriangulatedRaster.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Outcome;
using foundation::Result;

/// Reads all rows in file order, one by one: when a header promises more than the file holds, no more memory
/// is touched than the file's content needs.
Outcome readSamples(const RasterSource& source, GdalSession& gdal, Raster& raster)
{
    SampleDecoder decoder(source, gdal);
    raster.heightsM.reserve(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
    std::vector<double> row(static_cast<std::size_t>(raster.columns));
    for (int r = 0; r < raster.rows; ++r)
    {
        const CPLErr result = GDALRasterIO(source.band(), GF_Read, 0, r, raster.columns, 1, row.data(),
                                           raster.columns, 1, GDT_Float64, 0, 0);
        if (result != CE_None || gdal.hasFailed())
            return Error{
                source.name + ", row " + std::to_string(r + 1) + " of " + std::to_string(raster.rows),
                "cannot be read (" + gdal.firstError() + ")", "fetch it again: it is truncated or damaged"};
        for (const double value : row)
            raster.heightsM.push_back(decoder.heightM(value));
    }
    raster.implausible = decoder.implausible;

    if (isDriver(source, "GRASSASCIIGrid"))
    {
        const Result<std::vector<std::size_t>> nulls = grassNulls(source.gdalPath, raster.heightsM.size());
        if (!nulls) return Error{source.name, nulls.error().what, nulls.error().remedy};
        for (const std::size_t i : *nulls)
            if (i < raster.heightsM.size()) raster.heightsM[i] = std::numeric_limits<float>::quiet_NaN();
    }
    return foundation::success();
}

/// Opens a raster of heights. Errors: those of openSource() and checkShape().
Result<RasterSource> openHeights(const std::filesystem::path& file, GdalSession& gdal)
{
    Result<RasterSource> source = openSource(file, gdal);
    if (!source) return source;
    if (const Outcome shape = checkShape(*source); !shape) return shape.error();
    return source;
}

Raster sizeOf(const RasterSource& source)
{
    Raster raster;
    raster.columns = GDALGetRasterXSize(source.dataset.get());
    raster.rows = GDALGetRasterYSize(source.dataset.get());
    return raster;
}

} // namespace

Result<Raster> readRaster(const std::filesystem::path& file, GdalSession& gdal)
{
    if (isTriangulation(file)) return readTriangulation(file, gdal);
    const Result<RasterSource> source = openHeights(file, gdal);
    if (!source) return source.error();
    Raster raster = sizeOf(*source);
    if (const Outcome samples = readSamples(*source, gdal, raster); !samples) return samples.error();
    if (const Outcome oriented = orientRaster(source->name, source->dataset.get(), raster); !oriented)
        return oriented.error();
    noteSouthUp(source->dataset.get(), gdal);
    if (raster.frame) raster.crsWkt = crsWktOf(*source);
    return raster;
}

Result<Raster> readHead(const std::filesystem::path& file, GdalSession& gdal)
{
    if (isTriangulation(file)) return readTriangulationHead(file);
    const Result<RasterSource> source = openHeights(file, gdal);
    if (!source) return source.error();
    Raster raster = sizeOf(*source);
    if (const auto turn = readOrientation(source->name, source->dataset.get(), raster); !turn)
        return turn.error();
    if (raster.frame) raster.crsWkt = crsWktOf(*source);
    return raster;
}

} // namespace osgTerrainROAM::core
