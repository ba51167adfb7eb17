// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osgTerrainROAM/core/features/ShapeImport.h>

#include "FeatureTags.h"
#include "GroundPlacer.h"
#include "ShapeBytes.h"
#include "VectorSource.h"

namespace osgTerrainROAM::core
{

namespace
{

/// Adds the tags of OGR's hstore text: "width"=>"7","surface"=>"gravel".
void addOtherTags(const std::string& text, MapShape& shape)
{
    for (std::size_t at = text.find('"'); at != std::string::npos; at = text.find('"', at))
    {
        const std::size_t end = text.find("\"=>\"", at + 1);
        if (end == std::string::npos) return;
        const std::string key = text.substr(at + 1, end - at - 1);
        if (std::string value = hstoreValue(text, key); !value.empty())
            shape.tags.emplace(key, std::move(value));
        at = text.find('"', end + 4);
        if (at == std::string::npos) return;
        ++at;
    }
}

void addTags(OGRFeature& feature, MapShape& shape)
{
    shape.id = feature.GetFID();
    for (int i = 0; i < feature.GetFieldCount(); ++i)
    {
        if (!feature.IsFieldSetAndNotNull(i)) continue;
        const std::string name = feature.GetFieldDefnRef(i)->GetNameRef();
        if (name == "other_tags")
            addOtherTags(feature.GetFieldAsString(i), shape);
        else
            shape.tags.emplace(name, feature.GetFieldAsString(i));
    }
}

/// Reads the layers of one source into `set`.
class ShapeReader
{
public:
    explicit ShapeReader(const PlacedTile& tile) : _placer(tile) {}

    void take(OGRFeature& feature, OGRCoordinateTransformation* toWgs84)
    {
        MapShape shape;
        addTags(feature, shape);
        if (const OGRGeometry* geometry = feature.GetGeometryRef())
            add(*geometry, shape, toWgs84, 0);
        else
            ++set.invalid;
    }

    ShapeSet set;

private:
    void add(const OGRGeometry& geometry, const MapShape& like, OGRCoordinateTransformation* toWgs84,
             int depth)
    {
        const auto type = wkbFlatten(geometry.getGeometryType());
        if (type == wkbPoint)
            addPoint(*geometry.toPoint(), like, toWgs84);
        else if (type == wkbPolygon)
            addArea(*geometry.toPolygon(), like, toWgs84);
        else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) && depth < 8)
            for (const OGRGeometry* part : *geometry.toGeometryCollection())
                add(*part, like, toWgs84, depth + 1);
        else
        {
            ++set.lines;
            if (type == wkbLineString) addLine(*geometry.toLineString(), like, toWgs84);
        }
    }

    void addLine(const OGRLineString& line, const MapShape& like, OGRCoordinateTransformation* toWgs84)
    {
        MapLine made{like.id, {}, like.tags};
        for (glm::dvec2 vertex : pathOf(line, false))
        {
            if (!transform(vertex, toWgs84)) return;
            made.points.push_back(_placer.placed(vertex.x, vertex.y));
        }
        if (made.points.size() > 1 && _placer.meetsTile(made.points)) set.linear.push_back(std::move(made));
    }

    void addPoint(const OGRPoint& point, MapShape shape, OGRCoordinateTransformation* toWgs84)
    {
        glm::dvec2 vertex(point.getX(), point.getY());
        if (point.IsEmpty() || !transform(vertex, toWgs84))
        {
            ++set.invalid;
            return;
        }
        const glm::dvec2 place = _placer.placed(vertex.x, vertex.y);
        shape.point = place;
        keep(std::move(shape), {place});
    }

    void addArea(const OGRPolygon& polygon, MapShape shape, OGRCoordinateTransformation* toWgs84)
    {
        for (const OGRLinearRing* ring : polygon)
        {
            auto path = pathOf(*ring, true);
            bool isValid = path.size() >= 3;
            for (glm::dvec2& vertex : path)
            {
                isValid = isValid && transform(vertex, toWgs84);
                if (isValid) vertex = _placer.placed(vertex.x, vertex.y);
            }
            if (isValid)
                shape.rings.push_back(std::move(path));
            else if (shape.rings.empty())
                break; // without an outline there is no area
        }
        if (shape.rings.empty())
            ++set.invalid;
        else
            keep(shape, shape.rings.front());
    }

    void keep(MapShape shape, const std::vector<glm::dvec2>& places)
    {
        if (_placer.meetsTile(places))
            set.shapes.push_back(std::move(shape));
        else
            ++set.outside;
    }

    GroundPlacer _placer;
};

foundation::Result<ShapeSet> readShapes(const std::filesystem::path& source, const PlacedTile& tile)
{
    ShapeReader reader(tile);
    auto read = forEachFeature(source, tile,
                               [&](OGRFeature& feature, OGRLayer&, OGRCoordinateTransformation* toWgs84)
                               {
                                   reader.take(feature, toWgs84);
                                   return foundation::success();
                               });
    if (!read) return read.error();
    reader.set.notes = std::move(*read);
    return std::move(reader.set);
}

} // namespace

foundation::Result<ShapeSet> importShapes(const std::filesystem::path& source, const PlacedTile& tile,
                                          const foundation::KeptFrom& kept)
{
    return kept.findOrRead(
        "shapes", source, {}, shapesIn, [&] { return readShapes(source, tile); },
        [](const ShapeSet& set) { return bytesOf(set); });
}

} // namespace osgTerrainROAM::core
