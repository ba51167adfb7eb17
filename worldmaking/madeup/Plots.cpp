// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/Plots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "worldmaking/land/ModelPoints.h"
#include "worldmaking/madeup/SmoothPath.h"
#include "worldmaking/plan/Noise.h"

namespace worldmaking
{

namespace
{

using scenery::models::Dice;

constexpr double kSteepestPlot = 0.22, kAlongM = 4.0, kLookM = 6.0;

/// A house that may be built. Units: metres.
struct PlannedHouse
{
    const char* kind = "house";
    double frontM = 10.0, depthM = 8.0, setbackM = 4.0, gapM = 8.0; ///< gapM: to the next plot
    int levels = 1;
    bool isRow = false;
    const char* roof = "gabled";
};

/// The gap of two convex outlines along the directions of their edges: negative where they overlap.
double separationM(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b)
{
    double most = -1e300;
    for (const auto* ring : {&a, &b})
        for (std::size_t i = 0; i < ring->size(); ++i)
        {
            const glm::dvec2 edge = glm::normalize((*ring)[(i + 1) % ring->size()] - (*ring)[i]),
                             axis(edge.y, -edge.x);
            double highA = -1e300, lowA = 1e300, highB = -1e300, lowB = 1e300;
            for (const glm::dvec2& p : a)
                highA = std::max(highA, glm::dot(p, axis)), lowA = std::min(lowA, glm::dot(p, axis));
            for (const glm::dvec2& p : b)
                highB = std::max(highB, glm::dot(p, axis)), lowB = std::min(lowB, glm::dot(p, axis));
            most = std::max({most, lowB - highA, lowA - highB});
        }
    return most;
}

PlannedHouse houseFor(const Settlement& settlement, double outwards, Dice& dice)
{
    const double draw = dice.unit();
    if (settlement.kind == SettlementKind::town && outwards < 0.28)
        return {draw < 0.2 ? "retail" : "residential",
                dice.between(9.0, 13.0),
                dice.between(10.0, 12.5),
                2.4,
                0.0,
                2 + dice.below(3),
                true};
    if (settlement.kind == SettlementKind::town && outwards < 0.6 && draw < 0.35)
        return {"apartments", dice.between(16.0, 26.0), 11.5,  5.0,
                9.0,          3 + dice.below(2),        false, draw < 0.12 ? "flat" : "hipped"};
    if (settlement.kind == SettlementKind::town && outwards > 0.8 && draw < 0.12)
        return {"industrial", dice.between(28.0, 45.0), dice.between(20.0, 30.0), 9.0, 12.0, 1, false,
                "flat"};
    if (settlement.kind == SettlementKind::hamlet && draw > 0.4) // a generated model, which has its own size
        return {"house", 13.5, 12.0, dice.between(5.0, 9.0), dice.between(8.0, 16.0)};
    if (settlement.kind != SettlementKind::town && draw < 0.16)
        return {"barn", dice.between(14.0, 22.0), dice.between(9.0, 11.0), 7.0, 9.0, 1};
    return {"house",
            dice.between(9.0, 13.5),
            dice.between(8.0, 10.5),
            dice.between(4.0, 8.0),
            dice.between(6.0, settlement.kind == SettlementKind::town ? 11.0 : 18.0),
            1 + dice.below(2),
            false,
            draw > 0.8 ? "hipped" : "gabled"};
}

Tags tagsOfHouse(const PlannedHouse& house, Dice& dice)
{
    Tags tags{{"building", house.kind},
              {"building:levels", std::to_string(house.levels)},
              {"roof:shape", house.roof}};
    if (std::string_view(house.kind) == "retail") tags["shop"] = "yes";
    static constexpr std::array<const char*, 6> kColours{"#efe6d2", "#e9d7b8", "#f2eee4",
                                                         "#dcc9a3", "#d9d2c6", "#e6c9a8"};
    if (std::string_view(house.kind) != "barn" && std::string_view(house.kind) != "industrial")
        tags["building:colour"] = dice.oneOf(kColours);
    return tags;
}

/// Places along one street.
class HouseBuilder
{
public:
    HouseBuilder(const PlotRules& rules, TakenPlots& taken) : _rules(rules), _taken(taken) {}

    bool build(const PlanRings& rings, double gapM)
    {
        const auto& ring = rings.front();
        for (std::size_t i = 0; i < ring.size(); ++i)
        {
            const glm::dvec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
            const int steps = std::max(2, static_cast<int>(std::ceil(glm::distance(from, to) / kLookM)));
            for (int k = 0; k < steps; ++k)
                if (!isGood(glm::mix(from, to, static_cast<double>(k) / steps))) return false;
        }
        return _taken.take(rings, gapM);
    }

private:
    bool isGood(const glm::dvec2& place) const
    {
        if (!_rules.ground.isLand(place) || !_rules.isFree(place) ||
            _rules.ground.slope(place) > kSteepestPlot)
            return false;
        const auto way = _rules.web.nearest(place, 9.0);
        return !way || way->distanceM > _rules.web.ways()[way->way].halfWidthM() + kStreetRoomM;
    }

    const PlotRules& _rules;
    TakenPlots& _taken;
};

/// Parks a vehicle where there is room.
void park(const glm::dvec2& place, const glm::dvec2& ahead, HouseBuilder& builder, Dice& dice,
          MadeShapes& shapes)
{
    const bool isVan = dice.chance(0.15);
    if (!builder.build(rectangleOf(place, ahead, isVan ? 5.6 : 4.7, 2.1), 0.35)) return;
    shapes.push_back(pointShape(place, {{"model", isVan ? "van" : "saloon"},
                                        {"heading", bearingOf(ahead)},
                                        {"seed", std::to_string(1 + dice.below(isVan ? 1 : 2))}}));
}

/// Where a house stands: its middle, the way along its street, and the way from the street.
struct HousePlace
{
    glm::dvec2 middle, along, out;
};

/// What belongs to a house: a car beside it or cars before it, trees behind it.
void furnish(const PlannedHouse& house, const HousePlace& place, HouseBuilder& builder, Dice& dice,
             MadeShapes& shapes)
{
    const auto& [middle, along, out] = place;
    const std::string_view kind = house.kind;
    const double frontM = 0.5 * house.depthM; // from the middle to the wall at the street
    if (kind == "house" && dice.chance(0.5))
        park(middle + (0.5 * house.frontM + 1.8) * along - dice.between(0.0, 2.0) * out,
             dice.chance(0.5) ? out : -out, builder, dice, shapes);
    if (kind == "apartments" || kind == "industrial")
        for (double at = -0.5 * house.frontM + 1.6; at < 0.5 * house.frontM - 1.0; at += 2.7)
            if (dice.chance(0.55))
                park(middle + at * along - (frontM + 2.9) * out, -out, builder, dice, shapes);
    if (kind != "house" && kind != "barn") return;
    for (int i = 0; i < 3; ++i)
        if (dice.chance(0.45))
            shapes.push_back(pointShape(middle + (frontM + dice.between(5.0, 16.0)) * out +
                                            dice.between(-9.0, 9.0) * along,
                                        {{"natural", "tree"}, {"leaf_type", "broadleaved"}}));
}

/// The church and the square, as near to the middle as they find room.
void addMiddle(const Settlement& settlement, const PlotRules& rules, TakenPlots& taken, Dice& dice,
               MadeShapes& shapes)
{
    HouseBuilder street(rules, taken);
    const bool isTown = settlement.kind == SettlementKind::town;
    bool hasChurch = settlement.kind == SettlementKind::hamlet, hasSquare = !isTown;
    for (double away = 20.0; away < 160.0 && !(hasChurch && hasSquare); away += 6.0)
        for (int i = 0; i < 16; ++i)
        {
            const double angle = 0.3927 * i + 0.1 * away;
            const glm::dvec2 place = settlement.middle + away * glm::dvec2(std::cos(angle), std::sin(angle));
            const auto way = rules.web.nearest(place, 120.0);
            if (!way) continue;
            if (!hasSquare)
            {
                const PlanRings square = rectangleOf(place, way->along, 46.0, 34.0);
                hasSquare = street.build(square, 1.0);
                if (hasSquare)
                    shapes.push_back(
                        areaShape(square, {{"highway", "pedestrian"}, {"area", "yes"}, {"surface", "sett"}}));
                continue;
            }
            if (hasChurch) break;
            const double sizeM = isTown ? 1.25 : 1.0;
            const PlanRings whole = rectangleOf(place, way->along, sizeM * 34.0, sizeM * 16.0);
            if (!street.build(whole, 4.0)) continue;
            hasChurch = true;
            const glm::dvec2 nave = place + sizeM * 3.0 * way->along,
                             tower = place - sizeM * 12.1 * way->along;
            shapes.push_back(areaShape(rectangleOf(nave, way->along, sizeM * 23.0, sizeM * 11.0),
                                       {{"building", "church"}, {"roof:shape", "gabled"}}));
            shapes.push_back(areaShape(rectangleOf(tower, way->along, sizeM * 6.5, sizeM * 6.5),
                                       {{"building", "church"},
                                        {"height", std::to_string(static_cast<int>(sizeM * 28.0))},
                                        {"roof:height", std::to_string(static_cast<int>(sizeM * 9.0))},
                                        {"roof:shape", "pyramidal"}}));
        }
    for (int i = 0; i < 3 && hasChurch; ++i) // trees of the square and the churchyard
    {
        const glm::dvec2 place =
            settlement.middle + glm::dvec2(dice.between(-60.0, 60.0), dice.between(-60.0, 60.0));
        shapes.push_back(pointShape(place, {{"natural", "tree"}, {"leaf_type", "broadleaved"}}));
    }
}

} // namespace

bool TakenPlots::isFree(const PlanRings& rectangle, double gapM) const
{
    const MapBox box = boxOf(rectangle.front());
    bool isFree = true;
    _grid.near({box.low - gapM, box.high + gapM}, [&](std::size_t i)
               { isFree = isFree && separationM(rectangle.front(), _taken[i].front()) >= gapM; });
    return isFree;
}

bool TakenPlots::take(const PlanRings& rectangle, double gapM)
{
    if (!isFree(rectangle, gapM)) return false;
    _grid.add(_taken.size(), boxOf(rectangle.front()));
    _taken.push_back(rectangle);
    return true;
}

MadeShapes housesAlong(const Settlement& settlement, int number, const PlotRules& rules, TakenPlots& taken)
{
    MadeShapes shapes;
    Dice dice(seedFor(rules.seed, 31, static_cast<std::uint64_t>(number)));
    addMiddle(settlement, rules, taken, dice, shapes);
    HouseBuilder street(rules, taken);
    for (const MadeWay& way : rules.web.ways())
    {
        if (way.settlement != number && way.settlement >= 0) continue;
        const auto points = evenPoints(way.points, kAlongM);
        for (const double side : {1.0, -1.0})
        {
            PlannedHouse wanted = houseFor(settlement, 0.5, dice);
            bool isStale = true;
            for (std::size_t i = 2; i + 2 < points.size(); ++i)
            {
                const double outwards = glm::distance(points[i], settlement.middle) / settlement.radiusM();
                if (outwards > 1.05) continue;
                if (isStale) wanted = houseFor(settlement, outwards, dice);
                isStale = false;
                const glm::dvec2 along = glm::normalize(points[i + 1] - points[i - 1]),
                                 out = side * glm::dvec2(-along.y, along.x);
                const double frontM = way.halfWidthM() + kStreetRoomM + wanted.setbackM;
                const glm::dvec2 middle = points[i] + (frontM + 0.5 * wanted.depthM) * out;
                const PlanRings rings = rectangleOf(middle, along, wanted.frontM, wanted.depthM);
                if (!street.build(rings, wanted.isRow ? 0.05 : kGapM)) continue;
                if (settlement.kind == SettlementKind::hamlet && wanted.depthM == 12.0)
                    shapes.push_back(pointShape(middle, {{"model", "family-house"},
                                                         {"heading", bearingOf(along)},
                                                         {"seed", std::to_string(1 + dice.below(3))}}));
                else
                    shapes.push_back(areaShape(rings, tagsOfHouse(wanted, dice)));
                furnish(wanted, {middle, along, out}, street, dice, shapes);
                if (std::string_view(wanted.kind) == "house" && dice.chance(0.35))
                {
                    const PlanRings shed = rectangleOf(middle + (0.5 * wanted.depthM + 7.0) * out +
                                                           dice.between(-3.0, 3.0) * along,
                                                       along, dice.between(4.0, 6.5), dice.between(3.2, 5.0));
                    if (street.build(shed, 1.5)) shapes.push_back(areaShape(shed, {{"building", "shed"}}));
                }
                const double nextM = 0.5 * wanted.frontM + wanted.gapM;
                i += static_cast<std::size_t>(std::max(0.0, nextM / kAlongM - 1.0));
                isStale = true;
            }
        }
    }
    return shapes;
}

MadeShapes farmsAlong(std::size_t most, const std::vector<Settlement>& settlements, const PlotRules& rules,
                      TakenPlots& taken, WayWeb& web)
{
    MadeShapes shapes;
    Dice dice(seedFor(rules.seed, 32));
    std::vector<glm::dvec2> farms;
    HouseBuilder street(rules, taken);
    const std::size_t roads = web.ways().size();
    for (std::size_t attempt = 0; attempt < 40 * most && farms.size() < most && roads > 0; ++attempt)
    {
        const auto& way = web.ways()[static_cast<std::size_t>(dice.below(static_cast<int>(roads)))];
        const auto number = static_cast<std::size_t>(&way - web.ways().data());
        if (way.settlement >= 0 || way.points.size() < 12) continue;
        const auto at = static_cast<std::size_t>(3 + dice.below(static_cast<int>(way.points.size()) - 6));
        const glm::dvec2 along = glm::normalize(way.points[at + 1] - way.points[at - 1]);
        const glm::dvec2 out = (dice.chance(0.5) ? 1.0 : -1.0) * glm::dvec2(-along.y, along.x);
        const glm::dvec2 gate = way.points[at];
        const double driveM = dice.between(70.0, 160.0);
        const glm::dvec2 yard = gate + driveM * out;
        const auto isNear = [&](const glm::dvec2& other, double m) { return glm::distance(other, yard) < m; };
        if (std::any_of(farms.begin(), farms.end(),
                        [&](const auto& other) { return isNear(other, 700.0); }) ||
            std::any_of(settlements.begin(), settlements.end(),
                        [&](const Settlement& other)
                        { return isNear(other.middle, other.radiusM() + 350.0); }))
            continue;
        bool isGentle = true;
        for (double m = 10.0; m <= driveM + 40.0; m += 10.0)
        {
            const glm::dvec2 place = gate + m * out;
            const auto other = web.nearest(place, 45.0, number);
            isGentle = isGentle && !other && rules.ground.isLand(place) && rules.isFree(place) &&
                       rules.ground.slope(place) < 0.09 && (m < 60.0 || !web.nearest(place, 45.0));
        }
        if (!isGentle) continue;
        for (const glm::dvec2& knot : {gate})
            isGentle = isGentle && glm::distance(knot, way.points.front()) > 60.0 &&
                       glm::distance(knot, way.points.back()) > 60.0;
        if (!isGentle) continue;
        const glm::dvec2 end = yard - 6.0 * out;
        web.add({"service", {gate, glm::mix(gate, end, 0.5), end}, -1});
        farms.push_back(yard);
        const auto add = [&](const glm::dvec2& place, double lengthM, double widthM, Tags tags)
        {
            const PlanRings rings = rectangleOf(place, along, lengthM, widthM);
            if (street.build(rings, 2.0)) shapes.push_back(areaShape(rings, std::move(tags)));
        };
        add(yard - 22.0 * along + 6.0 * out, 14.0, 10.5,
            {{"building", "farm"}, {"building:levels", "2"}, {"roof:shape", "gabled"}});
        add(yard + 24.0 * along + 4.0 * out, 13.0, 26.0,
            {{"building", "barn"}, {"roof:shape", "gabled"}, {"height", "9"}});
        add(yard + 2.0 * along + 30.0 * out, 34.0, 12.0,
            {{"building", "barn"}, {"roof:shape", "gabled"}, {"height", "7"}});
        shapes.push_back(pointShape(yard + 44.0 * along + 26.0 * out, {{"man_made", "silo"}}));
        shapes.push_back(
            areaShape(rectangleOf(yard + 8.0 * out, along, 110.0, 80.0), {{"landuse", "farmyard"}}));
    }
    return shapes;
}

} // namespace worldmaking
