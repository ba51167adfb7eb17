// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/Runways.h"

#include <array>
#include <cmath>

#include <foundation/ReadableFile.h>
#include <glm/glm.hpp>
#include <ogrsf_frmts.h>

#include "worldmaking/map/GdalScope.h"

namespace worldmaking
{

namespace
{

using foundation::Error;

constexpr double kMetresPerFoot = 0.3048;
constexpr double kDefaultWidthM = 23.0;

std::string surfaceOf(const std::string& text)
{
    const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
    if (has("ASP") || has("CON") || has("BIT") || has("asp") || has("Asp") || has("Con") || has("PEM"))
        return "asphalt";
    return has("GRV") || has("GVL") || has("rav") ? "gravel" : "grass";
}

} // namespace

foundation::Result<RunwayTable> readRunways(const std::filesystem::path& file)
{
    if (const auto readable = foundation::checkReadable(file); !readable) return readable.error();
    GdalScope gdal;
    gdal.setFile(file.string());
    const char* const drivers[] = {"CSV", nullptr};
    const DatasetPtr dataset(
        GDALDataset::Open(file.string().c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers));
    OGRLayer* const layer = dataset ? dataset->GetLayer(0) : nullptr;
    if (!layer) return Error{file.string(), "is no table", "give runways of OurAirports as .csv"};
    for (const char* column : {"le_latitude_deg", "le_longitude_deg", "he_latitude_deg", "he_longitude_deg",
                               "width_ft", "surface", "closed", "le_ident", "he_ident", "airport_ident"})
        if (layer->GetLayerDefn()->GetFieldIndex(column) < 0)
            return Error{file.string(), std::string("has no column ") + column,
                         "give runways of OurAirports, with the line of names"};
    RunwayTable table;
    while (const OGRFeatureUniquePtr row{layer->GetNextFeature()})
    {
        const auto text = [&](const char* column) { return std::string(row->GetFieldAsString(column)); };
        const auto number = [&](const char* column) { return row->GetFieldAsDouble(column); };
        Runway runway{text("airport_ident"),
                      text("le_ident") + "/" + text("he_ident"),
                      {number("le_longitude_deg"), number("le_latitude_deg")},
                      {number("he_longitude_deg"), number("he_latitude_deg")},
                      kMetresPerFoot * number("width_ft"),
                      surfaceOf(text("surface"))};
        if (!(runway.widthM >= 3.0 && runway.widthM <= 200.0)) runway.widthM = kDefaultWidthM;
        const bool hasEnds = !text("le_latitude_deg").empty() && !text("he_latitude_deg").empty() &&
                             std::abs(runway.from.y) < 90.0 && std::abs(runway.to.y) < 90.0 &&
                             runway.from != runway.to;
        if (text("closed") == "1" || !hasEnds)
            ++table.unusable;
        else
            table.runways.push_back(std::move(runway));
    }
    table.notes = gdal.notes();
    return table;
}

std::optional<PlanRings> stripOf(const Runway& runway, const MapPlane& plane)
{
    const auto from = plane.toPlan(runway.from), to = plane.toPlan(runway.to);
    if (!from || !to || glm::length(*to - *from) < 1.0) return std::nullopt;
    const glm::dvec2 along = glm::normalize(*to - *from), left(-along.y, along.x);
    const glm::dvec2 a = *from - kStripEndM * along, b = *to + kStripEndM * along;
    const glm::dvec2 side = (0.5 * runway.widthM + kStripSideM) * left;
    return PlanRings{{a - side, b - side, b + side, a + side}};
}

} // namespace worldmaking
