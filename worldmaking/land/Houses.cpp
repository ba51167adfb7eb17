// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/Houses.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/glm.hpp>
#include <ogr_geometry.h>

#include "scenery/buildings/BuildingRules.h"
#include "scenery/buildings/Outline.h"
#include "worldmaking/land/HouseParts.h"
#include "worldmaking/land/Passages.h"
#include "worldmaking/map/GdalScope.h"
#include "worldmaking/map/OgrPolygon.h"
#include "worldmaking/plan/PlanGrid.h"
#include "worldmaking/plan/Waters.h"

namespace worldmaking
{

namespace
{

constexpr double kLeastShare = 0.45; ///< of a house that is cut back

bool isUnderground(const Tags& tags)
{
    if (valueOf(tags, "location") == "underground") return true;
    const std::string_view layer = valueOf(tags, "layer");
    return !layer.empty() && layer.front() == '-';
}

/// Leaves out houses that lie over larger ones.
void partOverlapping(std::vector<House>& houses, HouseReport& report)
{
    std::vector<std::size_t> order(houses.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto areaAt = [&](std::size_t i) { return scenery::areaOf(houses[i].building.rings); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return areaAt(a) > areaAt(b); });
    PlanGrid grid;
    std::vector<char> stays(houses.size(), 1);
    for (const std::size_t i : order)
    {
        const auto& rings = houses[i].building.rings;
        const double most = std::max(kMostOverlapM2, kMostOverlap * areaAt(i));
        grid.near(boxOf(rings.front()),
                  [&](std::size_t other)
                  {
                      const bool isOne = houses[i].whole != 0 && houses[i].whole == houses[other].whole;
                      if (!isOne && stays[i] && commonAreaOf(rings, houses[other].building.rings) > most)
                          stays[i] = 0;
                  });
        if (stays[i])
            grid.add(i, boxOf(rings.front()));
        else
            ++report.overlapping;
    }
    std::vector<House> kept;
    for (std::size_t i = 0; i < houses.size(); ++i)
        if (stays[i]) kept.push_back(std::move(houses[i]));
    houses = std::move(kept);
}

/// Looks at one thing after the other.
class HouseTaker
{
public:
    HouseTaker(const LandMap& map, const MapPlane& plane, const HouseRoom& room, HouseReport& report)
        : _plane(plane), _room(room), _waters(map, plane), _passages(map, plane), _report(report)
    {
    }

    /// `wholeId`: of the building that it is a part of, or 0.
    void take(const LandShape& shape, std::int64_t wholeId, std::vector<House>& houses)
    {
        const std::size_t before = houses.size();
        const bool isParted = takeShape(shape, houses);
        for (std::size_t i = before; i < houses.size(); ++i)
            houses[i].whole = wholeId == 0 && isParted ? shape.id : wholeId;
    }

private:
    /// Returns whether it has become several houses, beside a passage and over it.
    bool takeShape(const LandShape& shape, std::vector<House>& houses)
    {
        ++_report.read;
        const auto rings = shape.form == ShapeForm::area ? _plane.toPlan(shape.paths) : std::nullopt;
        const auto parts = rings ? _passages.part(*rings, kHouseRoomM) : std::nullopt;
        const auto whole = parts && !isUnderground(shape.tags) ? buildingOf(shape, *rings) : std::nullopt;
        if (!whole)
        {
            if (auto house = takeWhole(shape)) houses.push_back(*std::move(house));
            return false;
        }
        ++_report.passages;
        const double heightM = whole->eavesM + whole->roofM;
        LandShape part = shape;
        part.tags.insert_or_assign("height", std::to_string(heightM));
        part.tags.insert_or_assign("roof:shape", "flat");
        part.tags.erase("roof:height");
        for (const PlanRings& beside : parts->beside)
            takePart(part, beside, *whole, houses);
        if (heightM < kLeastPassedM) return true;
        part.tags.insert_or_assign("min_height", std::to_string(kPassageM));
        for (const PlanRings& over : parts->over)
            takePart(part, over, *whole, houses);
        return true;
    }

    /// Takes a part of a house, in the colours of the whole.
    void takePart(LandShape part, const PlanRings& rings, const scenery::Building& whole,
                  std::vector<House>& houses)
    {
        auto degrees = _plane.toDegrees(rings);
        if (!degrees) return;
        part.paths = std::move(*degrees);
        auto house = takeWhole(part);
        if (!house) return;
        house->building.wallTint = whole.wallTint;
        house->building.roofTint = whole.roofTint;
        houses.push_back(*std::move(house));
    }

    std::optional<House> takeWhole(const LandShape& shape)
    {
        if (isUnderground(shape.tags)) return leave(_report.underground);
        const auto rings = _plane.toPlan(shape.paths);
        auto building = rings ? buildingOf(shape, *rings) : std::nullopt;
        if (!building) return leave(_report.unusable);
        for (const glm::dvec2& corner : building->rings.front())
            if (!_room.hasGround(corner)) return leave(_report.beyondGround);
        for (const PlanRings& strip : _room.strips)
            if (commonAreaOf(strip, building->rings) > 0.0) return leave(_report.onRunway);
        const auto middle = scenery::rectangleAround(building->rings.front()).middle;
        if (_waters.contain(middle)) return leave(_report.inWater);
        const bool isOver = building->liftedM >= kPassageM;
        auto free = isOver ? std::optional(building->rings)
                           : _room.roads.cutBack(building->rings, kHouseRoomM, kLeastShare);
        if (!free) return leave(_report.onRoad);
        House house{shape, std::move(*building)};
        if (*free != house.building.rings)
        {
            ++_report.cutBack;
            const auto again = shape.form == ShapeForm::area ? buildingOf(shape, *free) : std::nullopt;
            if (!again) return leave(_report.onRoad);
            house.building = *again;
        }
        auto degrees = _plane.toDegrees(house.building.rings);
        if (!degrees) return leave(_report.unusable);
        if (shape.form == ShapeForm::area) house.shape.paths = std::move(*degrees);
        return house;
    }

    static std::optional<House> leave(std::size_t& count)
    {
        ++count;
        return std::nullopt;
    }

    static std::optional<scenery::Building> buildingOf(const LandShape& shape, const PlanRings& rings)
    {
        const auto id = static_cast<std::uint64_t>(shape.id);
        if (shape.form == ShapeForm::area) return scenery::buildingOf(rings, shape.tags, id);
        return scenery::towerOf(rings.front().front(), shape.tags, id);
    }

    const MapPlane& _plane;
    const HouseRoom& _room;
    Waters _waters;
    Passages _passages;
    HouseReport& _report;
};

} // namespace

double commonAreaOf(const PlanRings& a, const PlanRings& b)
{
    const GdalScope quiet; // GEOS tells of outlines that cross themselves; they have no common area then
    const auto first = polygonOf(a), second = polygonOf(b);
    double area = 0.0;
    if (first->Intersects(second.get()))
    {
        const std::unique_ptr<OGRGeometry> common(first->Intersection(second.get()));
        const auto type = common ? wkbFlatten(common->getGeometryType()) : wkbUnknown;
        if (type == wkbPolygon) area = common->toPolygon()->get_Area();
        if (type == wkbMultiPolygon || type == wkbGeometryCollection)
            area = common->toGeometryCollection()->get_Area();
    }
    return area;
}

std::vector<House> housesOf(const LandMap& map, const MapPlane& plane, const HouseRoom& room,
                            HouseReport& report)
{
    HouseTaker taker(map, plane, room, report);
    std::vector<House> houses;
    for (const HouseShape& area : houseShapesOf(map, plane, report.parts))
        taker.take(area.shape, area.whole, houses);
    for (const LandShape& shape : map.shapes)
        if (shape.form == ShapeForm::point && scenery::towerOf(shape.paths.front().front(), shape.tags, 0))
            taker.take(shape, 0, houses);
    partOverlapping(houses, report);
    for (const House& house : houses)
        ++(house.shape.form == ShapeForm::point ? report.towers : report.standing);
    return houses;
}

} // namespace worldmaking
