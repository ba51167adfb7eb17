// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/PlanArea.h"

#include <ogr_geometry.h>

#include "worldmaking/map/GdalScope.h"

namespace worldmaking
{

namespace
{

constexpr int kQuarterSteps = 3; ///< of rounded corners

std::vector<glm::dvec2> pointsOf(const OGRLinearRing& ring)
{
    std::vector<glm::dvec2> points;
    for (int i = 0; i + 1 < ring.getNumPoints(); ++i)
        points.emplace_back(ring.getX(i), ring.getY(i));
    return points;
}

void addPolygons(const OGRGeometry& shape, double leastM2, std::vector<PlanRings>& parts)
{
    const auto type = wkbFlatten(shape.getGeometryType());
    if (type == wkbPolygon)
    {
        const OGRPolygon& polygon = *shape.toPolygon();
        if (polygon.IsEmpty() || polygon.get_Area() < leastM2) return;
        PlanRings rings;
        for (const OGRLinearRing* ring : polygon)
            rings.push_back(pointsOf(*ring));
        parts.push_back(std::move(rings));
    }
    else if (type == wkbMultiPolygon || type == wkbGeometryCollection)
        for (const OGRGeometry* part : *shape.toGeometryCollection())
            addPolygons(*part, leastM2, parts);
}

} // namespace

PlanArea::PlanArea(std::shared_ptr<const OGRGeometry> shape)
    : _shape(shape && !shape->IsEmpty() ? std::move(shape) : nullptr)
{
}

PlanArea::PlanArea(const PlanRings& rings)
{
    auto polygon = std::make_shared<OGRPolygon>();
    for (const auto& ring : rings)
    {
        auto* const line = new OGRLinearRing; // the polygon's from here on
        for (const glm::dvec2& corner : ring)
            line->addPoint(corner.x, corner.y);
        line->closeRings();
        polygon->addRingDirectly(line);
    }
    _shape = std::move(polygon);
}

PlanArea PlanArea::around(const std::vector<glm::dvec2>& line, double radiusM)
{
    const GdalScope quiet;
    OGRLineString path;
    for (const glm::dvec2& point : line)
        path.addPoint(point.x, point.y);
    return PlanArea(std::shared_ptr<const OGRGeometry>(path.Buffer(radiusM, kQuarterSteps)));
}

PlanArea PlanArea::joined(const std::vector<PlanArea>& areas)
{
    const GdalScope quiet;
    OGRGeometryCollection all;
    for (const PlanArea& area : areas)
        if (area._shape) all.addGeometry(area._shape.get());
    if (all.IsEmpty()) return {};
    const std::shared_ptr<OGRGeometry> flat(all.Buffer(0.0));
    return PlanArea(flat);
}

PlanArea PlanArea::grown(double byM) const
{
    const GdalScope quiet;
    return _shape ? PlanArea(std::shared_ptr<const OGRGeometry>(_shape->Buffer(byM, kQuarterSteps)))
                  : PlanArea();
}

PlanArea PlanArea::without(const PlanArea& other) const
{
    const GdalScope quiet;
    if (!_shape || !other._shape) return *this;
    return PlanArea(std::shared_ptr<const OGRGeometry>(_shape->Difference(other._shape.get())));
}

PlanArea PlanArea::simpler(double byM) const
{
    const GdalScope quiet;
    return _shape ? PlanArea(std::shared_ptr<const OGRGeometry>(_shape->SimplifyPreserveTopology(byM)))
                  : PlanArea();
}

bool PlanArea::meets(const PlanArea& other) const
{
    const GdalScope quiet;
    return _shape && other._shape && _shape->Intersects(other._shape.get());
}

std::vector<PlanRings> PlanArea::parts(double leastM2) const
{
    std::vector<PlanRings> parts;
    if (_shape) addPolygons(*_shape, leastM2, parts);
    return parts;
}

PlanRings grownRings(const PlanRings& rings, double byM)
{
    const auto parts = PlanArea(rings).grown(byM).parts(0.0);
    return parts.empty() ? rings : parts.front();
}

} // namespace worldmaking
