// SPDX-License-Identifier: Apache-2.0
#include "RasterSource.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <vector>

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <foundation/SmallLetters.h>
#include <ogr_srs_api.h>

#include "RasterPath.h"

namespace osgTerrainROAM::core
{

using foundation::Error;
using foundation::Outcome;
using foundation::Result;

namespace
{

/// What a file is that is no raster, by its name's ending, and which command takes it.
struct OtherKind
{
    std::string_view ending, what, remedy;
};

constexpr std::array kOtherKinds = {
    OtherKind{".pbf", "is a map of OpenStreetMap", "worldtool build ELEVATION --map FILE takes it"},
    OtherKind{".osm", "is a map of OpenStreetMap", "worldtool build ELEVATION --map FILE takes it"},
    OtherKind{".osm.gz", "is a map of OpenStreetMap", "worldtool build ELEVATION --map FILE takes it"},
    OtherKind{".osm.bz2", "is a map of OpenStreetMap", "worldtool build ELEVATION --map FILE takes it"},
    OtherKind{".xosc", "is a scenario", "trainer play FILE takes it"},
    OtherKind{".xodr", "is a road network", "trainer drive FILE and roadtool take it"},
    OtherKind{".igc", "is a recorded flight", "trainer play FILE takes it"},
    OtherKind{".gpx", "is a recording", "trainer play FILE takes it"},
    OtherKind{".kml", "is a recording", "trainer play FILE takes it"},
    OtherKind{".kmz", "is a recording", "trainer play FILE takes it"},
    OtherKind{".pm", "is a model", "pmtool takes it"},
    OtherKind{".obj", "is a model", "pmtool takes it"},
    OtherKind{".glb", "is a model", "pmtool takes it"},
    OtherKind{".gltf", "is a model", "pmtool takes it"},
    OtherKind{".las", "is a cloud of points", "make a raster of it first, with PDAL or gdal_grid"},
    OtherKind{".laz", "is a cloud of points", "make a raster of it first, with PDAL or gdal_grid"},
    OtherKind{".shp", "is a map of vectors", "worldtool build ELEVATION --map FOLDER takes it"},
};

std::optional<Error> otherKindOf(const std::filesystem::path& file)
{
    const std::string name = foundation::inSmallLetters(file.filename().string());
    for (const OtherKind& kind : kOtherKinds)
        if (name.ends_with(kind.ending))
            return Error{file.string(), std::string(kind.what) + ", no raster of heights",
                         std::string(kind.remedy)};
    return {};
}

} // namespace

Result<RasterSource> openSource(const std::filesystem::path& file, GdalSession& gdal)
{
    Result<std::vector<std::string>> paths = rasterPaths(file);
    if (!paths) return paths.error();
    std::string reason;
    gdal.setFile(file.string());
    for (const std::string& path : *paths)
    {
        gdal.clear();
        RasterDataset dataset(GDALOpenEx(path.c_str(),
                                         GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr,
                                         nullptr, nullptr));
        if (dataset && !gdal.hasFailed()) return RasterSource{file.string(), path, std::move(dataset)};
        if (reason.empty()) reason = gdal.firstError();
    }
    if (const auto other = otherKindOf(file)) return *other;
    const bool isSrtm = file.string().find(".hgt") != std::string::npos;
    return Error{file.string(), "is damaged or in no format that GDAL reads (" + reason + ")",
                 isSrtm ? "fetch it again, and keep its name: SRTM files are called like N46E008.hgt"
                        : "fetch it again, or convert it to GeoTIFF"};
}

bool isDriver(const RasterSource& source, const char* name)
{
    return std::string(GDALGetDriverShortName(GDALGetDatasetDriver(source.dataset.get()))) == name;
}

namespace
{

constexpr int kMaxSide = 32769; ///< the largest tile whose samples a 32-bit index can number

/// Finds truncated DTED files. GDAL reads missing profiles at the end as voids, because a cell may be
/// partial; a file that claims to be complete and lacks some has been truncated.
/// RasterSource: MIL-PRF-89020B: 3428 bytes of header, then per profile 12 bytes around its 2-byte heights.
bool isCutShortDted(const RasterSource& source)
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

} // namespace

Outcome checkShape(const RasterSource& source)
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

std::string crsWktOf(const RasterSource& source)
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

} // namespace osgTerrainROAM::core
