// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>

#include <osgTerrainROAM/core/features/FeatureImport.h>

#include "FeatureBytes.h"
#include "FeatureTags.h"
#include "GroundPlacer.h"
#include "VectorSource.h"

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

/// The paths of one feature, in the coordinates of its layer.
struct Geometry
{
    bool isArea = false;
    std::vector<std::vector<glm::dvec2>> paths;
};

/// Collects lines and areas of a geometry, also of a collection; if it contains an area, all its paths count
/// as areas.
void addGeometry(Geometry& geometry, const OGRGeometry& source, int depth)
{
    if (depth > 8) return;
    switch (wkbFlatten(source.getGeometryType()))
    {
    case wkbLineString:
        geometry.paths.push_back(pathOf(*source.toLineString(), false));
        break;
    case wkbPolygon:
        geometry.isArea = true;
        for (const OGRLinearRing* ring : *source.toPolygon())
            geometry.paths.push_back(pathOf(*ring, true));
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
    Reader(std::filesystem::path source, const PlacedTile& tile) : _source(std::move(source)), _placer(tile)
    {
    }

    Outcome read(OGRFeature& feature, OGRLayer& layer, OGRCoordinateTransformation* toWgs84)
    {
        ++set.report.read;
        take(feature, layer.GetName(), toWgs84);
        if (_vertices > kMostVertices)
            return Error{placeOf(_source, layer), "has more than 20 million vertices",
                         "cut it to the terrain's extent with ogr2ogr -clipsrc"};
        return success();
    }

    FeatureSet set;

private:
    void take(OGRFeature& feature, const char* layer, OGRCoordinateTransformation* toWgs84)
    {
        const TagLookup tag = [&](const char* name) { return attributeOf(feature, name); };
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

    /// Transforms vertices to degrees and drops paths of too few points. Returns false when nothing is left,
    /// or when a vertex cannot be transformed.
    static bool transform(Geometry& geometry, OGRCoordinateTransformation* toWgs84)
    {
        const std::size_t least = geometry.isArea ? 3 : 2;
        std::erase_if(geometry.paths, [=](const auto& path) { return path.size() < least; });
        for (auto& path : geometry.paths)
            for (glm::dvec2& vertex : path)
                if (!core::transform(vertex, toWgs84)) return false;
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

    std::filesystem::path _source;
    GroundPlacer _placer;
    std::size_t _vertices = 0;
};

Result<FeatureSet> readFeatures(const std::filesystem::path& source, const PlacedTile& tile)
{
    Reader reader(source, tile);
    auto read = forEachFeature(source, tile,
                               [&](OGRFeature& feature, OGRLayer& layer, OGRCoordinateTransformation* toWgs84)
                               { return reader.read(feature, layer, toWgs84); });
    if (!read) return read.error();
    reader.set.report.notes = std::move(*read);
    if (reader.set.features.empty())
        return Error{
            source.string(), "has nothing to paint: " + reader.set.report.message(),
            "give features of this place with kind = road, river, field or runway, or tags of OpenStreetMap"};
    return std::move(reader.set);
}

} // namespace

Result<FeatureSet> importFeatures(const std::filesystem::path& source, const PlacedTile& tile,
                                  const foundation::KeptFrom& kept)
{
    return kept.findOrRead(
        "features", source, {}, featuresIn, [&] { return readFeatures(source, tile); },
        [](const FeatureSet& set) { return bytesOf(set); });
}

} // namespace osgTerrainROAM::core
