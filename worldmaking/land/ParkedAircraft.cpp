// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/ParkedAircraft.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <foundation/NearestOnSegment.h>

#include "scenery/buildings/Outline.h"
#include "scenery/models/Dice.h"
#include "worldmaking/land/ModelPoints.h"
#include "worldmaking/plan/PlanGrid.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

namespace
{

using scenery::models::Dice;

/// An aircraft as it is parked. Units: metres.
struct Parked
{
    std::string_view model;
    double lengthM, spanM;
};

constexpr Parked kLight{"light-aircraft", 8.2, 11.0}, kAirliner{"airliner", 37.8, 35.8},
    kHelicopter{"helicopter", 11.0, 10.0};
constexpr double kOccupied = 0.45, kHelipadOccupied = 0.35;
constexpr double kAirlinerApronM = 80.0, kAirlinerRunwayM = 1800.0;
constexpr double kBesideM = 3.5;    ///< between two wing tips
constexpr double kTaxiM = 4.5;      ///< from an aircraft to the middle of a taxiway, beside half its size
constexpr double kBuildingM = 6.0;  ///< likewise to a building
constexpr double kLaneM = 18.0;     ///< between two rows on one apron
constexpr double kPositionsM = 5.0; ///< from a parking position to the apron that it belongs to
constexpr std::size_t kMostOnApron = 40;

/// A place for an aircraft: its middle, and where its nose points. Frame: the plane.
struct Stand
{
    glm::dvec2 middle{0.0}, ahead{0.0, 1.0};
};

bool isOf(const LandShape& shape, std::string_view aeroway)
{
    return valueOf(shape.tags, "aeroway") == aeroway;
}

/// What aircraft keep away from, and where the map wants them.
class Surroundings
{
public:
    Surroundings(const LandMap& map, const MapPlane& plane)
    {
        for (const LandShape& shape : map.shapes)
        {
            const bool isWay = shape.form == ShapeForm::line &&
                               (isOf(shape, "taxiway") || isOf(shape, "taxilane") || isOf(shape, "runway"));
            const bool isBuilding = shape.form == ShapeForm::area && !valueOf(shape.tags, "building").empty();
            const bool isPosition = shape.form != ShapeForm::area && isOf(shape, "parking_position");
            if (!isWay && !isBuilding && !isPosition) continue;
            const auto paths = plane.toPlan(shape.paths);
            if (!paths || paths->empty() || paths->front().empty()) continue;
            if (isPosition)
                _positions.push_back(paths->front());
            else
                addEdges(paths->front(), isBuilding);
            if (isWay && isOf(shape, "runway")) _runways.push_back(paths->front());
        }
    }

    const std::vector<std::vector<glm::dvec2>>& positions() const { return _positions; }

    /// The length of the longest runway with an end within 4 km. Units: metres.
    double runwayM(const glm::dvec2& place) const
    {
        double longest = 0.0;
        for (const auto& runway : _runways)
            if (std::min(glm::distance(place, runway.front()), glm::distance(place, runway.back())) < 4000.0)
                longest = std::max(longest, glm::distance(runway.front(), runway.back()));
        return longest;
    }

    /// The place on a taxiway within 200 m that is nearest; nothing where there is none.
    std::optional<glm::dvec2> nearestWay(const glm::dvec2& place) const
    {
        std::optional<glm::dvec2> nearest;
        forNear(place, 200.0,
                [&](const Edge& edge)
                {
                    const glm::dvec2 at = foundation::nearestOnSegment(place, edge.from, edge.to);
                    const bool isNearer =
                        !nearest || glm::distance(place, at) < glm::distance(place, *nearest);
                    if (!edge.isBuilding && isNearer) nearest = at;
                });
        return nearest;
    }

    bool isClear(const glm::dvec2& place, double halfM) const
    {
        bool isFree = true;
        forNear(place, halfM + std::max(kTaxiM, kBuildingM),
                [&](const Edge& edge)
                {
                    const glm::dvec2 at = foundation::nearestOnSegment(place, edge.from, edge.to);
                    const double roomM = halfM + (edge.isBuilding ? kBuildingM : kTaxiM);
                    isFree = isFree && glm::distance(place, at) >= roomM;
                });
        return isFree;
    }

private:
    struct Edge
    {
        glm::dvec2 from, to;
        bool isBuilding;
    };

    void addEdges(const std::vector<glm::dvec2>& path, bool isBuilding)
    {
        const std::size_t count = isBuilding ? path.size() : path.size() - 1;
        for (std::size_t i = 0; i < count; ++i)
        {
            const Edge edge{path[i], path[(i + 1) % path.size()], isBuilding};
            _grid.add(_edges.size(), boxOf({edge.from, edge.to}));
            _edges.push_back(edge);
        }
    }

    template<class Use>
    void forNear(const glm::dvec2& place, double withinM, const Use& use) const
    {
        _grid.near({place - withinM, place + withinM}, [&](std::size_t edge) { use(_edges[edge]); });
    }

    std::vector<Edge> _edges;
    PlanGrid _grid;
    std::vector<std::vector<glm::dvec2>> _positions, _runways;
};

/// Parks aircraft one after the other.
class Marshal
{
public:
    Marshal(const Surroundings& around, const MapPlane& plane) : _around(around), _plane(plane) {}

    /// Parks aircraft on an apron; its outline first, then what is cut out of it.
    void fill(const PlanRings& apron, std::int64_t id)
    {
        const scenery::PlanRectangle box = scenery::rectangleAround(apron.front());
        const bool isLarge =
            2.0 * box.halfWidthM >= kAirlinerApronM && _around.runwayM(box.middle) >= kAirlinerRunwayM;
        const Parked& parked = isLarge ? kAirliner : kLight;
        Dice dice(static_cast<std::uint64_t>(id));
        auto stands = positionsOn(apron, parked);
        if (stands.empty()) stands = rowsOn(box, parked);
        std::size_t count = 0;
        for (const Stand& stand : stands)
        {
            const bool isTaken = dice.chance(kOccupied);
            if (isTaken && count < kMostOnApron && isOn(apron, stand, parked) && park(stand, parked, dice))
                ++count;
        }
    }

    void addHelicopter(const glm::dvec2& place, std::int64_t id)
    {
        Dice dice(static_cast<std::uint64_t>(id));
        const double turn = dice.between(0.0, 6.28);
        if (dice.chance(kHelipadOccupied)) park({place, {std::cos(turn), std::sin(turn)}}, kHelicopter, dice);
    }

    std::vector<LandShape> shapes;

private:
    /// The parking positions of the map on an apron or just beside it.
    std::vector<Stand> positionsOn(const PlanRings& apron, const Parked& parked) const
    {
        std::vector<Stand> stands;
        const PlanRings grown{scenery::grownRing(apron.front(), kPositionsM)};
        for (const auto& position : _around.positions())
        {
            const glm::dvec2 nose = position.back();
            if (!scenery::isWithin(grown, nose)) continue;
            const auto way =
                position.size() > 1 ? std::optional(position[position.size() - 2]) : _around.nearestWay(nose);
            if (!way || glm::distance(*way, nose) < 0.5) continue;
            const glm::dvec2 ahead = glm::normalize(nose - *way);
            const double backM = position.size() > 1 ? 0.5 * parked.lengthM : 0.0;
            stands.push_back({nose - backM * ahead, ahead});
        }
        return stands;
    }

    /// Rows along both long sides, noses to the middle of the apron; one row where two have no room.
    static std::vector<Stand> rowsOn(const scenery::PlanRectangle& box, const Parked& parked)
    {
        std::vector<Stand> stands;
        const double pitchM = parked.spanM + kBesideM, edgeM = 0.5 * parked.lengthM + 2.0;
        const auto count = static_cast<int>(2.0 * (box.halfLengthM - 2.0) / pitchM);
        const bool hasTwo = 2.0 * box.halfWidthM >= 2.0 * parked.lengthM + kLaneM;
        for (const double side : {1.0, -1.0})
            for (int i = 0; i < count && (side > 0.0 || hasTwo); ++i)
                stands.push_back({box.middle + (i - 0.5 * (count - 1)) * pitchM * box.along +
                                      side * (box.halfWidthM - edgeM) * box.across(),
                                  -side * box.across()});
        return stands;
    }

    static bool isOn(const PlanRings& apron, const Stand& stand, const Parked& parked)
    {
        const glm::dvec2 along = 0.5 * parked.lengthM * stand.ahead,
                         across = 0.5 * parked.spanM * glm::dvec2(-stand.ahead.y, stand.ahead.x);
        // The nose of a position may reach over the edge, to the terminal.
        return scenery::isWithin(apron, stand.middle) && scenery::isWithin(apron, stand.middle + across) &&
               scenery::isWithin(apron, stand.middle - across) &&
               scenery::isWithin(apron, stand.middle - along);
    }

    /// False: no room.
    bool park(const Stand& stand, const Parked& parked, Dice& dice)
    {
        const double halfM = 0.5 * std::max(parked.lengthM, parked.spanM);
        if (!_around.isClear(stand.middle, halfM)) return false;
        for (const auto& [place, reachM] : _parked)
            if (glm::distance(place, stand.middle) < halfM + reachM + 1.0) return false;
        const auto degrees = _plane.toDegrees(stand.middle);
        if (!degrees) return false;
        LandShape shape;
        shape.paths = {{*degrees}};
        shape.tags = {{"model", std::string(parked.model)},
                      {"heading", bearingOf(stand.ahead)},
                      {"seed", std::to_string(1 + dice.below(4))}};
        shapes.push_back(std::move(shape));
        _parked.emplace_back(stand.middle, halfM);
        return true;
    }

    const Surroundings& _around;
    const MapPlane& _plane;
    std::vector<std::pair<glm::dvec2, double>> _parked; ///< middles and half sizes
};

} // namespace

std::vector<LandShape> parkedAircraft(const LandMap& map, const MapPlane& plane)
{
    const Surroundings around(map, plane);
    Marshal marshal(around, plane);
    for (const LandShape& shape : map.shapes)
    {
        const bool isApron = shape.form == ShapeForm::area && isOf(shape, "apron"),
                   isHelipad = shape.form != ShapeForm::line && isOf(shape, "helipad");
        const auto paths = isApron || isHelipad ? plane.toPlan(shape.paths) : std::nullopt;
        if (!paths || paths->empty() || paths->front().empty()) continue;
        if (isHelipad)
            marshal.addHelicopter(shape.form == ShapeForm::point
                                      ? paths->front().front()
                                      : scenery::rectangleAround(paths->front()).middle,
                                  shape.id);
        else if (paths->front().size() > 2)
            marshal.fill(*paths, shape.id);
    }
    return std::move(marshal.shapes);
}

} // namespace worldmaking
