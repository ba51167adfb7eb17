// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/OgrPieces.h"

#include <utility>

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

} // namespace

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

} // namespace worldmaking
