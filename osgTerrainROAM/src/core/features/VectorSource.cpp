// SPDX-License-Identifier: Apache-2.0
#include "VectorSource.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <system_error>

#include <gdal_priv.h>

#include "../heightfield/DatasetPtr.h"
#include "../heightfield/GdalSession.h"
#include "FeatureTags.h"

namespace osgTerrainROAM::core
{

using foundation::Error;
using foundation::Result;

namespace
{

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

Result<DatasetPtr> openVectorSource(const std::filesystem::path& source, const PlacedTile& tile,
                                    GdalSession& gdal)
{
    const std::string name = source.string();
    if (tile.frame().placement() == Placement::planar && tile.field().net)
        return Error{name, "cannot be laid on a georeferenced terrain that is placed on a plane",
                     "use placement = curved"};
    std::error_code ignored;
    if (!name.starts_with("/vsi") && !std::filesystem::exists(source, ignored))
        return Error{name, "no such file", "check the path"};
    DatasetPtr dataset(
        GDALDataset::Open(name.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
    if (!dataset)
        return Error{name, gdal.hasFailed() ? gdal.firstError() : "is no vector source that OGR can open",
                     "give a GeoPackage, GeoJSON, shapefile or the like"};
    return dataset;
}

Result<Transformation> transformationOf(const std::filesystem::path& source, OGRLayer& layer,
                                        const PlacedTile& tile)
{
    if (tile.frame().placement() == Placement::planar) return Transformation();
    const OGRSpatialReference* reference = layer.GetSpatialRef();
    // GeoPackages have special systems that mean "unknown".
    if (!reference || reference->IsLocal() || std::string_view(reference->GetName()).starts_with("Undefined"))
        return Error{placeOf(source, layer), "has no coordinate system",
                     "assign it with ogr2ogr -a_srs EPSG:…"};
    OGRSpatialReference geodetic;
    geodetic.SetWellKnownGeogCS("WGS84");
    geodetic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRSpatialReference> own(reference->Clone());
    own->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    Transformation made(OGRCreateCoordinateTransformation(own.get(), &geodetic));
    if (!made)
        return Error{placeOf(source, layer), "has a coordinate system that cannot be related to WGS84",
                     "reproject it with ogr2ogr -t_srs EPSG:4326"};
    return made;
}

Error damageOf(const std::filesystem::path& source, OGRLayer& layer, const GdalSession& gdal)
{
    return {placeOf(source, layer), "is damaged: " + gdal.firstError(),
            "fetch it again, or repair it with ogr2ogr"};
}

} // namespace

Result<std::vector<std::string>> forEachFeature(const std::filesystem::path& source, const PlacedTile& tile,
                                                const FeatureUse& use)
{
    GdalSession gdal;
    gdal.setFile(source.string());
    const auto dataset = openVectorSource(source, tile, gdal);
    if (!dataset) return dataset.error();
    for (OGRLayer* layer : (*dataset)->GetLayers())
    {
        const auto toWgs84 = transformationOf(source, *layer, tile);
        if (!toWgs84) return toWgs84.error();
        layer->ResetReading();
        while (true)
        {
            // Only an error that ends reading is damage; a vertex outside the Earth makes one feature
            // invalid.
            gdal.clear();
            const OGRFeatureUniquePtr feature{layer->GetNextFeature()};
            if (!feature) break;
            if (const auto used = use(*feature, *layer, toWgs84->get()); !used) return used.error();
        }
        if (gdal.hasFailed()) return damageOf(source, *layer, gdal);
    }
    return gdal.notes();
}

std::string placeOf(const std::filesystem::path& source, OGRLayer& layer)
{
    return source.string() + ": layer '" + layer.GetName() + "'";
}

bool transform(glm::dvec2& vertex, OGRCoordinateTransformation* toWgs84)
{
    if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y)) return false;
    if (!toWgs84) return std::max(std::abs(vertex.x), std::abs(vertex.y)) < 1e7;
    return toWgs84->Transform(1, &vertex.x, &vertex.y) && std::abs(vertex.y) <= 90.0 &&
           std::abs(vertex.x) <= 540.0;
}

std::string attributeOf(OGRFeature& feature, const char* name)
{
    if (const int index = feature.GetFieldIndex(name); index >= 0 && feature.IsFieldSetAndNotNull(index))
        return feature.GetFieldAsString(index);
    const int others = feature.GetFieldIndex("other_tags");
    return others >= 0 ? hstoreValue(feature.GetFieldAsString(others), name) : std::string();
}

std::vector<glm::dvec2> pathOf(const OGRSimpleCurve& curve, bool ring)
{
    std::vector<glm::dvec2> path;
    for (int i = 0; i < curve.getNumPoints(); ++i)
        if (const glm::dvec2 point(curve.getX(i), curve.getY(i)); path.empty() || point != path.back())
            path.push_back(point);
    if (ring && path.size() > 1 && path.front() == path.back()) path.pop_back();
    return path;
}

} // namespace osgTerrainROAM::core
