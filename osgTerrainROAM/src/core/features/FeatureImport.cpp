// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <system_error>

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <osgTerrainROAM/core/features/FeatureImport.h>

#include "../heightfield/GdalSession.h"
#include "FeatureTags.h"
#include "GroundPlacer.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Outcome;
using foundation::Result;
using foundation::success;

constexpr std::size_t kMostUnknownNames = 32;     ///< counted separately in a report
constexpr std::size_t kMostVertices = 20'000'000; ///< 320 MB; more than a tile can need

struct DatasetCloser
{
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using DatasetPtr = std::unique_ptr<GDALDataset, DatasetCloser>;
using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

/// The paths of one feature, in the coordinates of its layer.
struct Geometry
{
    bool isArea = false;
    std::vector<std::vector<glm::dvec2>> paths;
};

void addPath(Geometry& geometry, const OGRSimpleCurve& curve, bool ring)
{
    std::vector<glm::dvec2> path;
    for (int i = 0; i < curve.getNumPoints(); ++i)
        if (const glm::dvec2 point(curve.getX(i), curve.getY(i)); path.empty() || point != path.back())
            path.push_back(point);
    if (ring && path.size() > 1 && path.front() == path.back()) path.pop_back();
    geometry.paths.push_back(std::move(path));
}

/// Collects lines and areas of a geometry, also of a collection; if it contains an area, all its paths count as areas.
void addGeometry(Geometry& geometry, const OGRGeometry& source, int depth)
{
    if (depth > 8) return;
    switch (wkbFlatten(source.getGeometryType()))
    {
    case wkbLineString:
        addPath(geometry, *source.toLineString(), false);
        break;
    case wkbPolygon:
        geometry.isArea = true;
        for (const OGRLinearRing* ring : *source.toPolygon())
            addPath(geometry, *ring, true);
        break;
    case wkbMultiLineString:
    case wkbMultiPolygon:
    case wkbGeometryCollection:
        for (const OGRGeometry* part : *source.toGeometryCollection())
            addGeometry(geometry, *part, depth + 1);
        break;
    default:
        break; // points and surfaces in space cannot be painted
    }
}

/// Reads one source into `set`.
class Reader
{
public:
    Reader(std::string name, const PlacedTile& tile, GdalSession& gdal)
        : _name(std::move(name)), _tile(tile), _placer(tile), _gdal(gdal)
    {
    }

    Outcome read(OGRLayer& layer)
    {
        auto made = transformationOf(layer);
        if (!made) return made.error();
        const Transformation transformation = std::move(*made);
        layer.ResetReading();
        while (true)
        {
            // Only an error that ends reading is damage; a vertex outside the Earth makes one feature invalid.
            _gdal.clear();
            const OGRFeatureUniquePtr feature{layer.GetNextFeature()};
            if (!feature) break;
            ++set.report.read;
            take(*feature, layer.GetName(), transformation.get());
            if (_vertices > kMostVertices)
                return Error{place(layer), "has more than 20 million vertices",
                             "cut it to the terrain's extent with ogr2ogr -clipsrc"};
        }
        if (_gdal.hasFailed())
            return Error{place(layer), "is damaged: " + _gdal.firstError(),
                         "fetch it again, or repair it with ogr2ogr"};
        return success();
    }

    FeatureSet set;

private:
    std::string place(OGRLayer& layer) const { return _name + ": layer '" + layer.GetName() + "'"; }

    /// From the layer's coordinates to WGS84; null on planar tiles.
    Result<Transformation> transformationOf(OGRLayer& layer) const
    {
        if (_tile.frame().placement() == Placement::planar) return Transformation();
        const OGRSpatialReference* reference = layer.GetSpatialRef();
        // GeoPackages have special systems that mean "unknown".
        if (!reference || reference->IsLocal() ||
            std::string_view(reference->GetName()).starts_with("Undefined"))
            return Error{place(layer), "has no coordinate system", "assign it with ogr2ogr -a_srs EPSG:…"};
        OGRSpatialReference geodetic;
        geodetic.SetWellKnownGeogCS("WGS84");
        geodetic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        const std::unique_ptr<OGRSpatialReference> own(reference->Clone());
        own->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        Transformation made(OGRCreateCoordinateTransformation(own.get(), &geodetic));
        if (!made)
            return Error{place(layer), "has a coordinate system that cannot be related to WGS84",
                         "reproject it with ogr2ogr -t_srs EPSG:4326"};
        return made;
    }

    void take(OGRFeature& feature, const char* layer, OGRCoordinateTransformation* toWgs84)
    {
        const TagLookup tag = [&](const char* name) { return attribute(feature, name); };
        const auto style = featureStyle(tag, layer);
        if (!style)
        {
            auto& unknown = set.report.unknown;
            const std::string name = unknownName(tag);
            ++unknown[unknown.size() < kMostUnknownNames || unknown.contains(name) ? name : "(others)"];
            return;
        }
        Geometry geometry;
        if (const OGRGeometry* source = feature.GetGeometryRef())
            addGeometry(geometry, *std::unique_ptr<OGRGeometry>(source->getLinearGeometry()), 0);
        if (!transform(geometry, toWgs84))
        {
            ++set.report.invalid;
            return;
        }
        put(geometry, *style);
    }

    static std::string attribute(OGRFeature& feature, const char* name)
    {
        if (const int index = feature.GetFieldIndex(name); index >= 0 && feature.IsFieldSetAndNotNull(index))
            return feature.GetFieldAsString(index);
        const int others = feature.GetFieldIndex("other_tags");
        return others >= 0 ? hstoreValue(feature.GetFieldAsString(others), name) : std::string();
    }

    /// Transforms vertices to degrees and drops paths of too few points. Returns false when nothing is left, or when a vertex cannot be
    /// transformed.
    static bool transform(Geometry& geometry, OGRCoordinateTransformation* toWgs84)
    {
        const std::size_t least = geometry.isArea ? 3 : 2;
        std::erase_if(geometry.paths, [=](const auto& path) { return path.size() < least; });
        for (auto& path : geometry.paths)
            for (glm::dvec2& vertex : path)
            {
                if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y)) return false;
                if (toWgs84 && !toWgs84->Transform(1, &vertex.x, &vertex.y)) return false;
                const bool onEarth = std::abs(vertex.y) <= 90.0 && std::abs(vertex.x) <= 540.0;
                if (toWgs84 ? !onEarth : !(std::max(std::abs(vertex.x), std::abs(vertex.y)) < 1e7))
                    return false;
            }
        return !geometry.paths.empty();
    }

    void put(const Geometry& geometry, const FeatureStyle& style)
    {
        GroundFeature made;
        made.style = style;
        // A field is an area; OpenStreetMap draws closed lines for some.
        made.isArea = geometry.isArea || style.kind == FeatureKind::field;
        std::vector<glm::dvec2> all;
        for (const auto& path : geometry.paths)
        {
            made.paths.push_back(_placer.placedLine(path, made.isArea));
            all.insert(all.end(), made.paths.back().begin(), made.paths.back().end());
        }
        if (made.isArea) std::erase_if(made.paths, [](const auto& path) { return path.size() < 3; });
        _vertices += all.size();
        if (made.paths.empty())
            ++set.report.invalid;
        else if (!_placer.meetsTile(all))
            ++set.report.outside;
        else
        {
            ++set.report.taken;
            set.features.push_back(std::move(made));
        }
    }

    std::string _name;
    const PlacedTile& _tile;
    GroundPlacer _placer;
    GdalSession& _gdal;
    std::size_t _vertices = 0;
};

} // namespace

Result<FeatureSet> importFeatures(const std::filesystem::path& source, const PlacedTile& tile)
{
    const std::string name = source.string();
    if (tile.frame().placement() == Placement::planar && tile.field().net)
        return Error{name, "cannot be laid on a georeferenced terrain that is placed on a plane",
                     "use placement = curved"};
    std::error_code ignored;
    if (!name.starts_with("/vsi") && !std::filesystem::exists(source, ignored))
        return Error{name, "no such file", "check the path"};
    GdalSession gdal;
    const DatasetPtr dataset(
        GDALDataset::Open(name.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
    if (!dataset)
        return Error{name, gdal.hasFailed() ? gdal.firstError() : "is no vector source that OGR can open",
                     "give a GeoPackage, GeoJSON, shapefile or the like"};
    Reader reader(name, tile, gdal);
    for (OGRLayer* layer : dataset->GetLayers())
        if (const Outcome read = reader.read(*layer); !read) return read.error();
    if (reader.set.features.empty())
        return Error{
            name, "has nothing to paint: " + reader.set.report.message(),
            "give features of this place with kind = road, river, field or runway, or tags of OpenStreetMap"};
    return std::move(reader.set);
}

} // namespace osgTerrainROAM::core
