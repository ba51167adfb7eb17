// SPDX-License-Identifier: Apache-2.0
#include "TerrainFile.h"

#include <memory>

#include <cpl_error.h>
#include <foundation/WholeFile.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

namespace islandgen
{

namespace
{

struct DatasetCloser
{
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, DatasetCloser>;

Dataset createRaster(const std::filesystem::path& file, int side)
{
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    if (!driver) return nullptr;
    const char* options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "ZLEVEL=6", nullptr};
    return Dataset(driver->Create(file.c_str(), side, side, 1, GDT_Float32, const_cast<char**>(options)));
}

void setPlace(GDALDataset& dataset, const Terrain& terrain)
{
    OGRSpatialReference utm;
    utm.importFromEPSG(32632);
    dataset.SetSpatialRef(&utm);
    const double cell = terrain.cellM;
    const double toCorner = 0.5 * terrain.heightM.side * cell; // of the north-western sample's cell
    double place[6] = {kCentreEastingM - toCorner, cell, 0.0, kCentreNorthingM + toCorner, 0.0, -cell};
    dataset.SetGeoTransform(place);
}

bool writeRows(GDALDataset& dataset, const Grid<float>& heightM)
{
    GDALRasterBand* band = dataset.GetRasterBand(1);
    band->SetUnitType("metre");
    std::vector<float> line(static_cast<std::size_t>(heightM.side));
    for (int row = 0; row < heightM.side; ++row)
    {
        const float* source = &heightM.at(0, heightM.side - 1 - row);
        line.assign(source, source + heightM.side);
        if (band->RasterIO(GF_Write, 0, row, heightM.side, 1, line.data(), heightM.side, 1, GDT_Float32, 0, 0,
                           nullptr) != CE_None)
        {
            return false;
        }
    }
    dataset.FlushCache();
    return true;
}

} // namespace

foundation::Outcome writeTerrain(const Terrain& terrain, const std::filesystem::path& file)
{
    GDALAllRegister();
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
    foundation::WholeFile whole(file);
    Dataset dataset = createRaster(whole.written(), terrain.heightM.side);
    bool written = dataset != nullptr;
    if (dataset)
    {
        setPlace(*dataset, terrain);
        written = writeRows(*dataset, terrain.heightM);
        dataset.reset();
        written = written && CPLGetLastErrorType() < CE_Failure;
    }
    const std::string reason = CPLGetLastErrorMsg();
    CPLPopErrorHandler();
    if (!written) return whole.failure("cannot be written", reason);
    return whole.commit();
}

} // namespace islandgen
