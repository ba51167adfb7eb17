// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/ClipShapes.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <ogr_geometry.h>

#include "worldmaking/map/GdalScope.h"
#include "worldmaking/map/OgrPolygon.h"

namespace worldmaking
{
namespace
{

using Path = std::vector<glm::dvec2>;

Path pathOf(const OGRSimpleCurve& curve, bool isRing)
{
    Path path;
    for (int i = 0; i < curve.getNumPoints() - (isRing ? 1 : 0); ++i)
        path.emplace_back(curve.getX(i), curve.getY(i));
    return path;
}

std::unique_ptr<OGRGeometry> geometryOf(const LandShape& shape)
{
    if (shape.form == ShapeForm::line)
    {
        auto line = std::make_unique<OGRLineString>();
        for (const glm::dvec2& place : shape.paths.front())
            line->addPoint(place.x, place.y);
        return line;
    }
    auto area = polygonOf(shape.paths);
    if (area->IsValid()) return area;
    return std::unique_ptr<OGRGeometry>(area->MakeValid());
}

/// Appends what is left of a shape, piece by piece.
void addPieces(const OGRGeometry& geometry, const LandShape& like, std::vector<LandShape>& pieces)
{
    const auto type = wkbFlatten(geometry.getGeometryType());
    LandShape piece{like.id, like.form, {}, like.tags};
    if (type == wkbLineString && like.form == ShapeForm::line)
        piece.paths.push_back(pathOf(*geometry.toLineString(), false));
    else if (type == wkbPolygon && like.form == ShapeForm::area)
        for (const OGRLinearRing* ring : *geometry.toPolygon())
            piece.paths.push_back(pathOf(*ring, true));
    else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection))
        for (const OGRGeometry* part : *geometry.toGeometryCollection())
            addPieces(*part, like, pieces);
    if (!piece.paths.empty() && piece.paths.front().size() > 1) pieces.push_back(std::move(piece));
}

bool reachesBeyond(const LandShape& shape, const MapBounds& bounds)
{
    return std::any_of(shape.paths.begin(), shape.paths.end(),
                       [&](const Path& path)
                       {
                           return !std::all_of(path.begin(), path.end(),
                                               [&](const glm::dvec2& place)
                                               { return bounds.contains(place); });
                       });
}

} // namespace

std::size_t clipTo(const MapBounds& bounds, double marginDeg, LandMap& map)
{
    const GdalScope quiet;
    const MapBounds wide{bounds.west - marginDeg, bounds.south - marginDeg, bounds.east + marginDeg,
                         bounds.north + marginDeg};
    const auto box = polygonOf({{{wide.west, wide.south},
                                 {wide.east, wide.south},
                                 {wide.east, wide.north},
                                 {wide.west, wide.north}}});
    std::vector<LandShape> kept;
    kept.reserve(map.shapes.size());
    std::size_t cut = 0;
    for (LandShape& shape : map.shapes)
    {
        if (!reachesBeyond(shape, wide))
        {
            kept.push_back(std::move(shape));
            continue;
        }
        ++cut;
        if (shape.form == ShapeForm::point) continue;
        const auto whole = geometryOf(shape);
        const std::unique_ptr<OGRGeometry> inside(whole ? whole->Intersection(box.get()) : nullptr);
        if (inside) addPieces(*inside, shape, kept);
    }
    map.shapes = std::move(kept);
    return cut;
}

} // namespace worldmaking
