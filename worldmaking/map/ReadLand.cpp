// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/ReadLand.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <foundation/ReadableFile.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "worldmaking/map/ConvertedXml.h"
#include "worldmaking/map/GdalScope.h"
#include "worldmaking/map/PlaceKey.h"

namespace worldmaking
{

namespace
{

using foundation::Error;

/// Adds the tags of OGR's hstore text: "width"=>"7","surface"=>"gravel", where \ stands before " and \.
void addOtherTags(std::string_view text, Tags& tags)
{
    std::vector<std::string> words;
    bool isInside = false;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        if (text[i] == '"')
        {
            isInside = !isInside;
            if (isInside) words.emplace_back();
        }
        else if (isInside)
            words.back() += text[i] == '\\' && i + 1 < text.size() ? text[++i] : text[i];
    }
    for (std::size_t i = 0; i + 1 < words.size(); i += 2)
        tags.emplace(std::move(words[i]), std::move(words[i + 1]));
}

/// Reads features into a map.
class LandReader
{
public:
    explicit LandReader(const MapBounds& bounds) : _bounds(bounds) {}

    void take(OGRFeature& feature, OGRCoordinateTransformation* toWgs84)
    {
        LandShape shape;
        shape.id = feature.GetFID();
        for (int i = 0; i < feature.GetFieldCount(); ++i)
        {
            if (!feature.IsFieldSetAndNotNull(i)) continue;
            const std::string_view name = feature.GetFieldDefnRef(i)->GetNameRef();
            const char* value = feature.GetFieldAsString(i);
            if (name == "other_tags")
                addOtherTags(value, shape.tags);
            else if (name == "osm_id" || name == "osm_way_id")
                shape.id = std::atoll(value);
            else if (*value)
                shape.tags.emplace(name, value);
        }
        if (const OGRGeometry* geometry = feature.GetGeometryRef())
            add(*std::unique_ptr<OGRGeometry>(geometry->getLinearGeometry()), shape, toWgs84, 0);
        else
            ++map.unusable;
    }

    LandMap map;

private:
    void add(const OGRGeometry& geometry, const LandShape& like, OGRCoordinateTransformation* toWgs84,
             int depth)
    {
        const auto type = wkbFlatten(geometry.getGeometryType());
        LandShape shape = like;
        if (type == wkbPoint)
        {
            const OGRPoint& point = *geometry.toPoint();
            shape.paths.push_back({{point.getX(), point.getY()}});
            keep(std::move(shape), toWgs84, 1);
        }
        else if (type == wkbLineString)
        {
            // GDAL takes closed ways as lines where it does not know that their tags mean areas.
            const bool isRing = geometry.toLineString()->get_IsClosed() && isAreaByTags(shape.tags);
            shape.form = isRing ? ShapeForm::area : ShapeForm::line;
            shape.paths.push_back(pathOf(*geometry.toLineString(), isRing));
            keep(std::move(shape), toWgs84, isRing ? 3 : 2);
        }
        else if (type == wkbPolygon)
        {
            shape.form = ShapeForm::area;
            for (const OGRLinearRing* ring : *geometry.toPolygon())
                shape.paths.push_back(pathOf(*ring, true));
            keep(std::move(shape), toWgs84, 3);
        }
        else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) && depth < 8)
            for (const OGRGeometry* part : *geometry.toGeometryCollection())
                add(*part, like, toWgs84, depth + 1);
        else
            ++map.unusable;
    }

    static bool isAreaByTags(const Tags& tags)
    {
        const std::string_view part = valueOf(tags, "building:part");
        return (!part.empty() && part != "no") || valueOf(tags, "waterway") == "riverbank";
    }

    static std::vector<glm::dvec2> pathOf(const OGRSimpleCurve& curve, bool isRing)
    {
        std::vector<glm::dvec2> path;
        for (int i = 0; i < curve.getNumPoints(); ++i)
            if (const glm::dvec2 place(curve.getX(i), curve.getY(i)); path.empty() || place != path.back())
                path.push_back(place);
        if (isRing && path.size() > 1 && path.front() == path.back()) path.pop_back();
        return path;
    }

    void keep(LandShape shape, OGRCoordinateTransformation* toWgs84, std::size_t least)
    {
        tagsOfClass(shape);
        const bool isWhole = !shape.paths.empty() && shape.paths.front().size() >= least;
        std::erase_if(shape.paths, [=](const auto& path) { return path.size() < least; });
        bool isUsable = isWhole, isInside = false;
        for (auto& path : shape.paths)
            for (glm::dvec2& place : path)
            {
                isUsable = isUsable && std::isfinite(place.x) && std::isfinite(place.y) &&
                           (!toWgs84 || toWgs84->Transform(1, &place.x, &place.y)) &&
                           std::abs(place.y) <= 90.0 && std::abs(place.x) <= 360.0;
                isInside = isInside || _bounds.contains(place);
            }
        if (!isUsable)
            ++map.unusable;
        else if (isInside)
            map.shapes.push_back(std::move(shape));
    }

    MapBounds _bounds;
};

using Transformations = std::vector<std::pair<OGRLayer*, std::unique_ptr<OGRCoordinateTransformation>>>;

foundation::Result<Transformations> transformationsOf(GDALDataset& dataset, const std::string& name)
{
    Transformations made;
    OGRSpatialReference geodetic;
    geodetic.SetWellKnownGeogCS("WGS84");
    geodetic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    for (OGRLayer* layer : dataset.GetLayers())
    {
        const OGRSpatialReference* reference = layer->GetSpatialRef();
        const std::string place = name + ": layer '" + layer->GetName() + "'";
        if (!reference || reference->IsLocal() ||
            std::string_view(reference->GetName()).starts_with("Undefined"))
            return Error{place, "has no coordinate system", "assign it with ogr2ogr -a_srs EPSG:…"};
        const std::unique_ptr<OGRSpatialReference> own(reference->Clone());
        own->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        std::unique_ptr<OGRCoordinateTransformation> way;
        if (!own->IsSame(&geodetic)) way.reset(OGRCreateCoordinateTransformation(own.get(), &geodetic));
        if (!way && !own->IsSame(&geodetic))
            return Error{place, "has a coordinate system that cannot be related to WGS84",
                         "reproject it with ogr2ogr -t_srs EPSG:4326"};
        made.emplace_back(layer, std::move(way));
    }
    return made;
}

/// GDAL names the formats of OpenStreetMap by their content; packed text it reads through a name of its own.
std::string openableName(const std::filesystem::path& file)
{
    return file.extension() == ".gz" ? "/vsigzip/" + file.string() : file.string();
}

/// A text that GDAL opens as a file, as long as this lives. The text must outlive it.
class FileInMemory
{
public:
    explicit FileInMemory(std::string& text)
        : _name("/vsimem/converted-" + std::to_string(reinterpret_cast<std::uintptr_t>(&text)) + ".osm")
    {
        VSIFCloseL(
            VSIFileFromMemBuffer(_name.c_str(), reinterpret_cast<GByte*>(text.data()), text.size(), FALSE));
    }
    ~FileInMemory() { VSIUnlink(_name.c_str()); }
    FileInMemory(const FileInMemory&) = delete;
    FileInMemory& operator=(const FileInMemory&) = delete;

    const std::string& name() const { return _name; }

private:
    std::string _name;
};

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

Error tooLarge(const std::string& name)
{
    return Error{name, "does not fit into memory",
                 "raise the limit (ulimit -v), or cut a part out with osmium extract or ogr2ogr -spat"};
}

} // namespace

foundation::Result<LandMap> readLand(const std::filesystem::path& file, const MapBounds& bounds)
{
    std::error_code ignored;
    const bool isFolder = std::filesystem::is_directory(file, ignored); // of shapefiles
    const bool isOfGdal = file.string().starts_with("/vsi");            // in an archive
    if (const auto readable = foundation::checkReadable(file); !isFolder && !isOfGdal && !readable)
        return readable.error();
    auto converted = convertedXml(file);
    if (!converted) return converted.error();
    GdalScope errors;
    const std::string name = file.string();
    errors.setFile(name);
    std::optional<FileInMemory> inMemory;
    if (*converted) inMemory.emplace(**converted);
    const std::string opened = inMemory ? inMemory->name() : openableName(file);
    const DatasetPtr dataset(
        GDALDataset::Open(opened.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
    if (errors.lacksMemory()) return tooLarge(name);
    if (!dataset)
        return Error{name, "cannot be read as a map" + (errors.hasFailed() ? ": " + errors.firstError() : ""),
                     "give a map as .osm, .osm.gz, .osm.pbf, GeoPackage, GeoJSON or shapefile"};
    const auto ways = transformationsOf(*dataset, name);
    if (!ways) return ways.error();
    LandReader reader(bounds);
    errors.clear();
    while (true) // layers of OpenStreetMap files come by turns
    {
        OGRLayer* layer = nullptr;
        const OGRFeatureUniquePtr feature(dataset->GetNextFeature(&layer, nullptr, nullptr, nullptr));
        if (!feature) break;
        const auto way =
            std::find_if(ways->begin(), ways->end(), [&](const auto& w) { return w.first == layer; });
        reader.take(*feature, way == ways->end() ? nullptr : way->second.get());
    }
    if (errors.lacksMemory()) return tooLarge(name);
    if (errors.hasFailed())
        return Error{name, "is damaged: " + errors.firstError(), "fetch it again, or repair it with ogr2ogr"};
    reader.map.notes.insert(reader.map.notes.end(), errors.notes().begin(), errors.notes().end());
    return std::move(reader.map);
}

void tagsOfClass(LandShape& shape)
{
    const std::string word(valueOf(shape.tags, "fclass"));
    if (word.empty()) return;
    const auto set = [&](const char* key, std::string value)
    { shape.tags.insert_or_assign(key, std::move(value)); };
    const std::string type(valueOf(shape.tags, "type"));
    if (shape.form == ShapeForm::line && !valueOf(shape.tags, "oneway").empty()) // residential, too
        set("highway", word.starts_with("track") ? "track" : word);
    else if (word == "building")
        set("building", type.empty() ? "yes" : type);
    else if (isOneOf(word, {"river", "stream", "canal", "drain"}) && shape.form == ShapeForm::line)
        set("waterway", word);
    else if (isOneOf(word, {"water", "reservoir", "river", "dock", "riverbank"}))
        set("natural", "water");
    else if (isOneOf(word,
                     {"wetland", "glacier", "beach", "cliff", "tree", "peak", "spring", "scrub", "heath"}))
        set("natural", word);
    else if (isOneOf(word, {"rail", "light_rail", "narrow_gauge", "tram", "funicular", "subway"}))
        set("railway", word);
    else if (isOneOf(word, {"forest", "meadow", "farmland", "farm", "grass", "orchard", "vineyard",
                            "residential", "industrial", "commercial", "retail", "cemetery", "allotments",
                            "quarry", "military", "farmyard"}))
        set("landuse", word == "farm" ? "farmland" : word);
    else if (isOneOf(word, {"park", "recreation_ground", "nature_reserve", "pitch"}))
        set("leisure", word);
    for (const char* key : {"bridge", "tunnel"})
        if (const auto value = valueOf(shape.tags, key); value == "T" || value == "F")
            set(key, value == "T" ? "yes" : "no");
    if (const auto oneway = valueOf(shape.tags, "oneway"); oneway == "F")
        set("oneway", "yes");
    else if (oneway == "T")
        set("oneway", "-1");
    else if (oneway == "B")
        set("oneway", "no");
}

StreetMap streetsOf(const LandMap& land)
{
    StreetMap streets;
    std::map<PlaceKey, std::uint32_t> nodes;
    std::int64_t nextId = 1;
    for (const LandShape& shape : land.shapes)
    {
        if (shape.form != ShapeForm::line || valueOf(shape.tags, "highway").empty()) continue;
        MapWay way{nextId++, {}, shape.tags};
        for (const glm::dvec2& place : shape.paths.front())
        {
            const PlaceKey key = placeKeyOf(place);
            const auto [found, isNew] =
                nodes.try_emplace(key, static_cast<std::uint32_t>(streets.nodes.size()));
            if (isNew)
                streets.nodes.push_back(
                    {static_cast<std::int64_t>(streets.nodes.size()) + 1, place.y, place.x});
            if (way.nodes.empty() || way.nodes.back() != found->second) way.nodes.push_back(found->second);
        }
        if (way.nodes.size() < 2)
            ++streets.shortWays;
        else
            streets.ways.push_back(std::move(way));
    }
    return streets;
}

} // namespace worldmaking
