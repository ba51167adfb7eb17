// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/Passages.h"

#include <memory>

#include <glm/geometric.hpp>
#include <ogr_geometry.h>

#include "worldmaking/map/GdalScope.h"
#include "worldmaking/map/OgrPieces.h"
#include "worldmaking/map/OgrPolygon.h"
#include "worldmaking/streets/LaneLayout.h"
#include "worldmaking/streets/StreetTraits.h"

namespace worldmaking
{

namespace
{

constexpr double kPassageEndM = 3.0; ///< a line may end so far within the house
constexpr double kLeastPartM2 = 4.0;
constexpr int kPassageCorners = 2; ///< of a quarter of a circle

bool isPassage(const LandShape& shape)
{
    if (shape.form != ShapeForm::line) return false;
    const auto covered = valueOf(shape.tags, "covered");
    return valueOf(shape.tags, "tunnel") == "building_passage" || (!covered.empty() && covered != "no");
}

/// The areas of a geometry as outlines with their holes.
std::vector<PlanRings> areasOf(const OGRGeometry& geometry)
{
    std::vector<LandShape> pieces;
    LandShape like;
    like.form = ShapeForm::area;
    addPieces(geometry, like, pieces);
    std::vector<PlanRings> areas;
    for (LandShape& piece : pieces)
        if (polygonOf(piece.paths)->get_Area() >= kLeastPartM2) areas.push_back(std::move(piece.paths));
    return areas;
}

} // namespace

Passages::Passages(const LandMap& map, const MapPlane& plane)
{
    for (const LandShape& shape : map.shapes)
    {
        if (!isPassage(shape)) continue;
        const auto traits = traitsOf(shape.tags);
        auto paths = traits ? plane.toPlan(shape.paths) : std::nullopt;
        if (!paths || paths->front().size() < 2) continue;
        auto& line = paths->front();
        const auto lengthen = [](glm::dvec2& end, const glm::dvec2& next)
        {
            if (const double lengthM = glm::distance(end, next); lengthM > 1e-3)
                end += (end - next) * (kPassageEndM / lengthM);
        };
        lengthen(line.front(), line[1]);
        lengthen(line.back(), line[line.size() - 2]);
        _grid.add(_passages.size(), boxOf(line));
        _passages.push_back({std::move(line), layoutOf(*traits).halfWidthM()});
    }
}

std::optional<PassageParts> Passages::part(const PlanRings& rings, double roomM) const
{
    if (_passages.empty()) return std::nullopt;
    const GdalScope quiet;
    std::unique_ptr<OGRGeometry> lanes;
    const auto house = polygonOf(rings);
    _grid.near(boxOf(rings.front()),
               [&](std::size_t i)
               {
                   OGRLineString line;
                   for (const glm::dvec2& place : _passages[i].line)
                       line.addPoint(place.x, place.y);
                   if (!line.Intersects(house.get())) return;
                   std::unique_ptr<OGRGeometry> band(
                       line.Buffer(_passages[i].halfM + roomM, kPassageCorners));
                   lanes.reset(lanes ? lanes->Union(band.get()) : band.release());
               });
    if (!lanes) return std::nullopt;
    const std::unique_ptr<OGRGeometry> beside(house->Difference(lanes.get())),
        over(house->Intersection(lanes.get()));
    if (!beside || !over) return std::nullopt;
    return PassageParts{areasOf(*beside), areasOf(*over)};
}

} // namespace worldmaking
