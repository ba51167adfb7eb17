// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/MadeUpLand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "worldmaking/madeup/Bridges.h"
#include "worldmaking/madeup/Contours.h"
#include "worldmaking/madeup/Lakes.h"
#include "worldmaking/madeup/Noise.h"
#include "worldmaking/madeup/Parcels.h"
#include "worldmaking/madeup/RoadPlan.h"
#include "worldmaking/madeup/SmoothPath.h"
#include "worldmaking/madeup/StreetGrowth.h"
#include "worldmaking/madeup/Woods.h"

namespace worldmaking
{

namespace
{

using scenery::models::Dice;

constexpr double kPaintedKm2 = 0.6, kRiverKm2 = 12.0, kBridgedKm2 = 2.0;
constexpr double kRoadCellM = 48.0, kLakeRoomM = 35.0;
constexpr double kFarmReachM = 2600.0; ///< of settlements: fields beyond are few
constexpr double kWoodBalkM = 2.0;     ///< between a field and a wood
constexpr std::size_t kMostHedges = 260;

/// A shore, or a ring round a runway: an outline grown by a distance.
PlanRings grownRings(const PlanRings& rings, double byM)
{
    const auto parts = PlanArea(rings).grown(byM).parts(0.0);
    return parts.empty() ? rings : parts.front();
}

std::string_view nameOf(SettlementKind kind)
{
    static constexpr std::array<std::string_view, 3> kNames{"town", "village", "hamlet"};
    return kNames[static_cast<std::size_t>(kind)];
}

double streamWidthM(double areaKm2)
{
    return std::clamp(1.2 * std::sqrt(areaKm2), 1.5, 14.0);
}

} // namespace

MadeUpLand::MadeUpLand(const GroundGrid& ground, const MadeUpSettings& settings)
    : _ground(ground), _settings(settings), _drainage(ground)
{
    const glm::dvec2 size = ground.box().high - ground.box().low;
    report.areaKm2 = size.x * size.y * 1e-6;
}

void MadeUpLand::make()
{
    airfield = airfieldOn(_ground);
    if (airfield)
    {
        ++report.airfields;
        _strip.add(airfield->ground());
        for (PlanRings& approach : airfield->approaches())
            _approaches.add(std::move(approach));
    }
    layWaters();
    settle();
    buildHouses();
    till();
    addAvenues();
    plantWoods();
    for (const Settlement& settlement : _settlements)
        places.emplace_back(nameOf(settlement.kind), settlement.middle);
    if (airfield) places.emplace_back("airfield", 0.5 * (airfield->from + airfield->to));
    for (const PlanRings& lake : _lakes.all())
        places.emplace_back("lake", scenery::rectangleAround(lake.front()).middle);
    emitStreets();
    emitLand();
}

void MadeUpLand::layWaters()
{
    _streams = _drainage.streams(_settings.aridity > 0.5 ? 8.0 * kPaintedKm2 : kPaintedKm2);
    AreaSet avoided = _strip;
    if (airfield) avoided.add(grownRings(airfield->ground(), 150.0));
    const auto most = static_cast<std::size_t>(std::clamp(report.areaKm2 / 150.0, 1.0, 4.0));
    for (PlanRings& lake :
         lakesOn(_ground, _drainage, _settings.seed, _settings.aridity > 0.5 ? 1 : most, avoided))
    {
        _shores.add(grownRings(lake, kLakeRoomM));
        _lakes.add(std::move(lake));
        ++report.lakes;
    }
}

bool MadeUpLand::isFree(const glm::dvec2& place) const
{
    return !_strip.contains(place) && !_approaches.contains(place) && !_shores.contains(place) &&
           _drainage.areaKm2(place) < kBridgedKm2;
}

double MadeUpLand::tollAt(const glm::dvec2& place) const
{
    if (_strip.contains(place) || _shores.contains(place)) return -1.0;
    const double wet = _drainage.areaKm2(place) > kBridgedKm2 ? 5.0 : 0.0;
    const double side = 12.0 * std::max(0.0, _ground.slope(place) - 0.12);
    return 1.0 + wet + side + (_approaches.contains(place) ? 2.0 : 0.0);
}

void MadeUpLand::settle()
{
    const auto free = [&](const glm::dvec2& place) { return isFree(place); };
    _settlements = settlementsOn(_ground, _drainage, _settings.seed, free);
    report.settlements = _settlements.size();
    RoadSearch search(_ground, std::max(kRoadCellM, 2.0 * _ground.cellM()),
                      [&](const glm::dvec2& place) { return tollAt(place); });
    report.unreached = planRoads(_settlements, search, _web);
    if (airfield) joinToWeb(airfield->gate(), "tertiary", search, _web);
    _web.weave();
    const StreetRules rules{_ground, free, _settings.seed};
    for (std::size_t i = 0; i < _settlements.size(); ++i)
        growStreets(_settlements[i], static_cast<int>(i), rules, _web);
    _web.weave();
}

void MadeUpLand::buildHouses()
{
    const PlotRules rules{_ground, _web, [&](const glm::dvec2& place) { return isFree(place); },
                          _settings.seed};
    const auto keep = [&](MadeShapes made)
    {
        for (MadeShape& shape : made)
        {
            report.houses += shape.tags.contains("building");
            shapes.push_back(std::move(shape));
        }
    };
    for (std::size_t i = 0; i < _settlements.size(); ++i)
    {
        const std::size_t before = _plots.all().size();
        keep(housesAlong(_settlements[i], static_cast<int>(i), rules, _plots));
        std::vector<PlanArea> parts;
        for (std::size_t plot = before; plot < _plots.all().size(); ++plot)
            parts.push_back(PlanArea(_plots.all()[plot]).grown(22.0));
        for (PlanRings& zone : PlanArea::joined(parts).simpler(2.0).parts(1000.0))
        {
            zone.resize(1); // what houses stand around belongs to them
            shapes.push_back(areaShape(zone, {{"landuse", "residential"}}));
            _zones.add(std::move(zone));
        }
    }
    const std::size_t before = _web.ways().size();
    const auto most = static_cast<std::size_t>(std::clamp(report.areaKm2 / 14.0, 2.0, 45.0));
    keep(farmsAlong(most, _settlements, rules, _plots, _web));
    report.farms = _web.ways().size() - before;
    for (std::size_t way = before; way < _web.ways().size(); ++way)
        _zones.add(rectangleOf(
            _web.ways()[way].points.back(),
            glm::normalize(_web.ways()[way].points.back() - _web.ways()[way].points.front()), 130.0, 120.0));
    _web.weave();
}

double MadeUpLand::farmWish(const glm::dvec2& place) const
{
    double away = 1e9;
    for (const Settlement& settlement : _settlements)
        away = std::min(away, glm::distance(settlement.middle, place) - settlement.radiusM());
    const double near = std::clamp(1.0 - away / kFarmReachM, -0.6, 1.0);
    const double high = std::max(0.0, *_ground.heightM(place) - 0.6 * _settings.treeLineM) / 300.0;
    return 0.35 + 0.5 * near - 3.0 * _ground.slope(place) +
           0.5 * (roughNoiseAt(place, 1300.0, seedFor(_settings.seed, 71)) - 0.5) - high -
           1.1 * std::max(0.0, _settings.aridity - 0.3);
}

void MadeUpLand::till()
{
    std::vector<PlanArea> pieces; // of what is taken, found by a grid
    PlanGrid grid;
    const auto take = [&](PlanArea area, const MapBox& box)
    {
        grid.add(pieces.size(), box);
        pieces.push_back(std::move(area));
    };
    const auto takeLine = [&](const std::vector<glm::dvec2>& line, double radiusM)
    {
        for (std::size_t i = 0; i + 1 < line.size(); i += 6)
        {
            const std::vector<glm::dvec2> piece(
                line.begin() + static_cast<std::ptrdiff_t>(i),
                line.begin() + static_cast<std::ptrdiff_t>(std::min(i + 7, line.size())));
            const MapBox box = boxOf(piece);
            take(PlanArea::around(piece, radiusM), {box.low - radiusM, box.high + radiusM});
        }
    };
    for (const MadeWay& way : _web.ways())
        takeLine(way.points, way.halfWidthM() + 6.0);
    for (const Stream& stream : _streams)
        takeLine(stream.points, 0.5 * streamWidthM(stream.areaKm2) + 8.0);
    for (const AreaSet* set : {&_strip, &_shores, &_zones})
        for (const PlanRings& rings : set->all())
            take(PlanArea(rings), boxOf(rings.front()));
    const auto taken = [&](const MapBox& box)
    {
        std::vector<PlanArea> near;
        grid.near(box, [&](std::size_t i) { near.push_back(pieces[i]); });
        return PlanArea::joined(near);
    };
    const ParcelRules rules{_ground, [&](const glm::dvec2& place) { return farmWish(place); }, taken,
                            _settings.seed};
    std::size_t number = 0;
    for (PlanRings& field : parcelsOn(rules))
    {
        addHedges(field, ++number);
        Dice dice(seedFor(_settings.seed, 72, number));
        static constexpr std::array<const char*, 6> kCrops{"wheat",    "barley", "maize",
                                                           "rapeseed", "wheat",  "potato"};
        const double meadow = 0.3 + 2.0 * _ground.slope(field.front().front());
        const bool isSmall = scenery::areaOf(field) < 9000.0;
        if (isSmall && dice.chance(0.05) && _settings.aridity < 0.5)
            shapes.push_back(areaShape(field, {{"landuse", "orchard"}}));
        else if (dice.chance(meadow))
            shapes.push_back(areaShape(field, {{"landuse", "meadow"}}));
        else
            shapes.push_back(areaShape(field, {{"landuse", "farmland"}, {"crop", dice.oneOf(kCrops)}}));
        _tilled.add(grownRings(field, kWoodBalkM));
        _fields.add(std::move(field));
        ++report.fields;
    }
}

/// Hedges along some of a field's sides, just outside it.
void MadeUpLand::addHedges(const PlanRings& field, std::size_t number)
{
    Dice dice(seedFor(_settings.seed, 73, number));
    if (report.hedges >= kMostHedges || !dice.chance(0.16)) return;
    const auto& ring = field.front();
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        const double lengthM = glm::distance(a, b);
        if (lengthM < 60.0 || !dice.chance(0.5)) continue;
        const glm::dvec2 along = (b - a) / lengthM, out(along.y, -along.x);
        const glm::dvec2 middle = 0.5 * (a + b) + 1.3 * out;
        if (_fields.contains(middle) || _zones.contains(middle) || _web.nearest(middle, 9.0)) continue;
        shapes.push_back(lineShape({a + 1.3 * out, b + 1.3 * out}, {{"barrier", "hedge"}}));
        ++report.hedges;
    }
}

/// Rows of trees along stretches of the larger roads.
void MadeUpLand::addAvenues()
{
    std::size_t number = 0;
    for (const MadeWay& way : _web.ways())
    {
        ++number;
        if (way.settlement >= 0 || (way.kind != "secondary" && way.kind != "tertiary")) continue;
        for (std::size_t i = 0; i + 1 < way.points.size(); ++i)
        {
            const glm::dvec2 middle = 0.5 * (way.points[i] + way.points[i + 1]);
            if (noiseAt(middle, 500.0, seedFor(_settings.seed, 74, number)) < 0.62) continue;
            const glm::dvec2 along = glm::normalize(way.points[i + 1] - way.points[i]),
                             across(-along.y, along.x);
            for (const double side : {1.0, -1.0})
            {
                const glm::dvec2 aside = side * (way.halfWidthM() + 5.0) * across;
                if (_zones.contains(middle + aside) || _approaches.contains(middle + aside) ||
                    _strip.contains(middle + aside))
                    continue;
                shapes.push_back(lineShape({way.points[i] + aside, way.points[i + 1] + aside},
                                           {{"natural", "tree_row"}, {"leaf_type", "broadleaved"}}));
            }
        }
    }
}

void MadeUpLand::plantWoods()
{
    const auto isTaken = [&](const glm::dvec2& place)
    {
        return _tilled.contains(place) || _zones.contains(place) || _strip.contains(place) ||
               _approaches.contains(place) || _lakes.contains(place);
    };
    const double dry = std::clamp((_settings.aridity - 0.2) / 0.6, 0.0, 1.0);
    WoodRules rules{_ground, _drainage, isTaken};
    rules.share = 0.2 * (1.0 - dry) + 0.02 * dry;
    rules.treeLineM = _settings.treeLineM;
    rules.seed = _settings.seed;
    for (PlanRings& wood : woodsOn(rules))
    {
        shapes.push_back(areaShape(std::move(wood), {{"natural", "wood"}}));
        ++report.woods;
    }
}

void MadeUpLand::emitStreets()
{
    const auto knots = _web.knots();
    std::vector<Stream> bridged;
    for (const Stream& stream : _streams)
        if (stream.areaKm2 > kBridgedKm2) bridged.push_back(stream);
    for (const MadeWay& way : _web.ways())
        for (const WayPart& part : bridgedParts(way, bridged, _ground, knots))
        {
            Tags tags{{"highway", std::string(way.kind)}};
            if (way.settlement >= 0) tags["sidewalk"] = "both";
            if (part.isBridge) tags["bridge"] = "yes", tags["layer"] = "1";
            report.bridges += part.isBridge;
            if (part.isBridge)
                places.emplace_back("bridge", 0.5 * (part.points.front() + part.points.back()));
            for (std::size_t i = 0; i + 1 < part.points.size(); ++i)
                report.roadsKm += 0.001 * glm::distance(part.points[i], part.points[i + 1]);
            shapes.push_back(lineShape(part.points, std::move(tags)));
        }
}

void MadeUpLand::emitLand()
{
    for (const PlanRings& lake : _lakes.all())
        shapes.push_back(areaShape(lake, {{"natural", "water"}, {"water", "lake"}}));
    for (const Stream& stream : _streams)
    {
        char width[16];
        std::snprintf(width, sizeof width, "%.1f", streamWidthM(stream.areaKm2));
        shapes.push_back(
            lineShape(smoothPath(stream.points),
                      {{"waterway", stream.areaKm2 > kRiverKm2 ? "river" : "stream"}, {"width", width}}));
    }
    for (const Settlement& settlement : _settlements)
    {
        shapes.push_back(pointShape(settlement.middle, {{"place", std::string(nameOf(settlement.kind))}}));
    }
    if (airfield)
        for (MadeShape& shape : airfield->shapes())
            shapes.push_back(std::move(shape));
    // All other low ground is grass, up to the trees' line: then no wood is seen where no tree stands.
    std::vector<float> lows;
    for (int row = 0; row < _ground.rows(); ++row)
        for (int column = 0; column < _ground.columns(); ++column)
        {
            const double height = _ground.heightAt(column, row);
            const bool isLow =
                _ground.hasGround(column, row) && (!_ground.hasSea() || height > GroundGrid::kShoreM);
            lows.push_back(isLow ? static_cast<float>(_settings.treeLineM + 100.0 - height) : -1.0F);
        }
    if (_settings.aridity > 0.5) return; // the desert's own ground
    const double cell = _ground.cellM();
    const MapBox box{_ground.box().low - 0.5 * cell, _ground.box().high + 0.5 * cell};
    for (PlanRings& area : areasAbove(lows, _ground.columns(), box, cell, 0.0, 1e5))
        shapes.push_back(areaShape(std::move(area), {{"natural", "grassland"}}));
}

} // namespace worldmaking
