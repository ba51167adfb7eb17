// SPDX-License-Identifier: Apache-2.0
#include "RasterFile.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>
#include <type_traits>

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include "GrassNulls.h"
#include "RasterOrientation.h"
#include "RasterPath.h"
#include "SampleDecoder.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Outcome;
using foundation::Result;

constexpr int kMaxSide = 32769; ///< the largest tile whose samples a 32-bit index can number

struct DatasetCloser
{
    void operator()(GDALDatasetH dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<std::remove_pointer_t<GDALDatasetH>, DatasetCloser>;

/// An open raster: GDAL's handles, and its path for GDAL.
struct Source
{
    std::string name; ///< for messages
    std::string gdalPath;
    Dataset dataset;

    GDALRasterBandH band() const { return GDALGetRasterBand(dataset.get(), 1); }
};

Result<Source> openSource(const std::filesystem::path& file, GdalSession& gdal)
{
    Result<std::vector<std::string>> paths = rasterPaths(file);
    if (!paths) return paths.error();
    std::string reason;
    for (const std::string& path : *paths)
    {
        gdal.clear();
        Dataset dataset(GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                                   nullptr, nullptr, nullptr));
        if (dataset && !gdal.hasFailed()) return Source{file.string(), path, std::move(dataset)};
        if (reason.empty()) reason = gdal.firstError();
    }
    const bool isSrtm = file.string().find(".hgt") != std::string::npos;
    return Error{file.string(), "is damaged or in no format that GDAL reads (" + reason + ")",
                 isSrtm ? "fetch it again, and keep its name: SRTM files are called like N46E008.hgt"
                        : "fetch it again, or convert it to GeoTIFF"};
}

bool isDriver(const Source& source, const char* name)
{
    return std::string(GDALGetDriverShortName(GDALGetDatasetDriver(source.dataset.get()))) == name;
}

/// Finds truncated DTED files. GDAL reads missing profiles at the end as voids, because a cell may be partial; a file that claims to
/// be complete and lacks some has been truncated.
/// Source: MIL-PRF-89020B: 3428 bytes of header, then per profile 12 bytes around its 2-byte heights.
bool isCutShortDted(const Source& source)
{
    if (!isDriver(source, "DTED")) return false;
    const char* partial = GDALGetMetadataItem(source.dataset.get(), "DTED_PartialCellIndicator", nullptr);
    if (partial && std::atoi(partial) != 0) return false;
    VSIStatBufL status;
    if (VSIStatL(source.gdalPath.c_str(), &status) != 0) return false;
    const auto profiles = static_cast<vsi_l_offset>(GDALGetRasterXSize(source.dataset.get()));
    const auto rows = static_cast<vsi_l_offset>(GDALGetRasterYSize(source.dataset.get()));
    return static_cast<vsi_l_offset>(status.st_size) < 3428 + profiles * (12 + 2 * rows);
}

Outcome checkShape(const Source& source)
{
    const int bands = GDALGetRasterCount(source.dataset.get());
    if (bands != 1)
        return Error{source.name, "has " + std::to_string(bands) + " bands where elevation has one",
                     "extract one with gdal_translate -b 1"};
    if (GDALGetRasterColorTable(source.band()))
        return Error{source.name, "holds palette colours, not heights",
                     "name the raster that the picture was made from"};
    if (GDALDataTypeIsComplex(GDALGetRasterDataType(source.band())))
        return Error{source.name, "holds complex numbers, not heights", "name a raster of plain numbers"};
    const int columns = GDALGetRasterXSize(source.dataset.get());
    const int rows = GDALGetRasterYSize(source.dataset.get());
    const std::string size = std::to_string(columns) + " x " + std::to_string(rows) + " samples";
    if (columns < 2 || rows < 2)
        return Error{source.name, size + " make no surface", "at least 2 x 2 are needed"};
    if (columns > kMaxSide || rows > kMaxSide)
        return Error{source.name, size + " are too many for one tile, which holds 32769 x 32769",
                     "cut a part out with gdal_translate -srcwin"};
    if (isCutShortDted(source))
        return Error{source.name, "calls itself complete and is not", "fetch it again: it is truncated"};
    return foundation::success();
}

/// Reads all rows in file order, one by one: when a header promises more than the file holds, no more memory is touched than the
/// file's content needs.
Outcome readSamples(const Source& source, GdalSession& gdal, Raster& raster)
{
    SampleDecoder decoder(source.band());
    raster.columns = GDALGetRasterXSize(source.dataset.get());
    raster.rows = GDALGetRasterYSize(source.dataset.get());
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

std::string crsWktOf(const Source& source)
{
    const OGRSpatialReferenceH crs = GDALGetSpatialRef(source.dataset.get());
    if (!crs) return {};
    char* wkt = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2018", nullptr};
    OSRExportToWktEx(crs, &wkt, options);
    std::string text = wkt ? wkt : "";
    CPLFree(wkt);
    return text;
}

} // namespace

Result<Raster> readRaster(const std::filesystem::path& file, GdalSession& gdal)
{
    const Result<Source> source = openSource(file, gdal);
    if (!source) return source.error();
    if (const Outcome shape = checkShape(*source); !shape) return shape.error();
    Raster raster;
    if (const Outcome samples = readSamples(*source, gdal, raster); !samples) return samples.error();
    if (const Outcome oriented = orientRaster(source->name, source->dataset.get(), raster); !oriented)
        return oriented.error();
    if (raster.frame) raster.crsWkt = crsWktOf(*source);
    return raster;
}

} // namespace osgTerrainROAM::core
