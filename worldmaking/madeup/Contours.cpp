// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/Contours.h"

#include <array>
#include <string>

#include <gdal_alg.h>
#include <ogrsf_frmts.h>

#include "worldmaking/madeup/PlanArea.h"
#include "worldmaking/map/GdalScope.h"

namespace worldmaking
{

namespace
{

constexpr double kAboveEverything = 1e6;

std::vector<glm::dvec2> contourOf(const OGRLinearRing& ring)
{
    std::vector<glm::dvec2> path;
    for (int i = 0; i + 1 < ring.getNumPoints(); ++i)
        path.emplace_back(ring.getX(i), ring.getY(i));
    return path;
}

void addAreas(const OGRGeometry& shape, double leastM2, std::vector<PlanRings>& areas)
{
    if (wkbFlatten(shape.getGeometryType()) != wkbPolygon)
    {
        for (const OGRGeometry* part : *shape.toGeometryCollection())
            addAreas(*part, leastM2, areas);
        return;
    }
    const OGRPolygon& polygon = *shape.toPolygon();
    if (polygon.get_Area() < leastM2) return;
    PlanRings rings;
    for (const OGRLinearRing* ring : polygon)
        if (rings.empty() || ring->get_Area() > 0.2 * leastM2) rings.push_back(contourOf(*ring));
    areas.push_back(std::move(rings));
}

} // namespace

std::vector<PlanRings> areasAbove(const std::vector<float>& values, int columns, const MapBox& box,
                                  double cellM, double level, double leastM2)
{
    const GdalScope quiet;
    const int rows = static_cast<int>(values.size()) / columns;
    GDALDriver* const memory = GetGDALDriverManager()->GetDriverByName("MEM");
    GDALDriver* const tables = GetGDALDriverManager()->GetDriverByName("Memory");
    if (!memory || !tables) return {};
    const DatasetPtr raster(memory->Create("", columns, rows, 1, GDT_Float32, nullptr));
    const DatasetPtr table(tables->Create("", 0, 0, 0, GDT_Unknown, nullptr));
    if (!raster || !table) return {};
    std::array<double, 6> place{box.low.x, cellM, 0.0, box.low.y, 0.0, cellM};
    raster->SetGeoTransform(place.data());
    auto* const cells = const_cast<float*>(values.data()); // GDAL's interface knows no const here
    if (raster->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, columns, rows, cells, columns, rows, GDT_Float32,
                                           0, 0) != CE_None)
        return {};
    OGRLayer* const layer = table->CreateLayer("areas", nullptr, wkbMultiPolygon, nullptr);
    OGRFieldDefn highest("highest", OFTReal); // of the values within an area
    layer->CreateField(&highest);
    char** options = CSLSetNameValue(nullptr, "POLYGONIZE", "YES");
    options = CSLSetNameValue(options, "FIXED_LEVELS", std::to_string(level).c_str());
    options = CSLSetNameValue(options, "ELEV_FIELD_MAX", "0");
    GDALContourGenerateEx(raster->GetRasterBand(1), layer, options, nullptr, nullptr);
    CSLDestroy(options);
    std::vector<PlanRings> areas;
    layer->ResetReading();
    while (const OGRFeatureUniquePtr feature{layer->GetNextFeature()})
    {
        const double most =
            feature->IsFieldSetAndNotNull(0) ? feature->GetFieldAsDouble(0) : kAboveEverything;
        if (most > level + 1e-3 && feature->GetGeometryRef())
            addAreas(*feature->GetGeometryRef(), leastM2, areas);
    }
    return areas;
}

} // namespace worldmaking
