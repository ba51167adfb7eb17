// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/MadeUpLand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "worldmaking/madeup/Lakes.h"
#include "worldmaking/madeup/RoadPlan.h"
#include "worldmaking/madeup/SmoothPath.h"
#include "worldmaking/madeup/StreetGrowth.h"
#include "worldmaking/madeup/ThroughRoad.h"

namespace worldmaking
{

namespace
{

constexpr double kPaintedKm2 = 0.6, kRoadCellM = 48.0, kLakeRoomM = 35.0;
constexpr double kBrookRoomM = 3.0;     ///< between a brook and a house
constexpr double kPlotGardenM = 30.0;   ///< what belongs to a house around it
constexpr double kSummitShare = 0.3;    ///< of the relief: summits are bare from so far below them on
constexpr double kLeastReliefM = 500.0; ///< of ground that has summits

/// Wind keeps the tops of mountains bare, however low they are. Nothing is bare where there are none.
/// Source: Körner, *Alpine treelines*, 2012, ch. 3 (lines are lower on isolated summits than in massifs).
double summitLineM(const GroundGrid& ground)
{
    std::vector<double> heights;
    for (int row = 0; row < ground.rows(); row += 2)
        for (int column = 0; column < ground.columns(); column += 2)
            if (ground.hasGround(column, row)) heights.push_back(ground.heightAt(column, row));
    if (heights.empty()) return 1e9;
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const double lowM = ground.hasSea() ? std::max(*low, 0.0) : *low;
    return *high - lowM < kLeastReliefM ? 1e9 : *high - kSummitShare * (*high - lowM);
}

} // namespace

MadeUpLand::MadeUpLand(const GroundGrid& ground, const MadeUpSettings& settings)
    : _ground(ground), _settings(settings), _drainage(ground)
{
    const glm::dvec2 size = ground.box().high - ground.box().low;
    report.areaKm2 = size.x * size.y * 1e-6;
    _treeLineM = std::min(settings.treeLineM, summitLineM(ground));
}

/// Pieces of a line that are short enough for a grid to find them.
std::vector<std::vector<glm::dvec2>> MadeUpLand::piecesOf(const std::vector<glm::dvec2>& line)
{
    constexpr std::size_t kSegments = 6;
    std::vector<std::vector<glm::dvec2>> pieces;
    for (std::size_t i = 0; i + 1 < line.size(); i += kSegments)
        pieces.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(i),
                            line.begin() +
                                static_cast<std::ptrdiff_t>(std::min(i + kSegments + 1, line.size())));
    return pieces;
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
    for (Stream& stream : _streams)
    {
        stream.points = smoothPath(stream.points);
        for (const auto& piece : piecesOf(stream.points))
            for (PlanRings& rings : PlanArea::around(piece, 0.5 * stream.widthM() + kBrookRoomM).parts(0.0))
                _brooks.add(std::move(rings));
    }
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
    RoadSearch search(_ground, std::max(kRoadCellM, 2.0 * _ground.cellM()),
                      [&](const glm::dvec2& place) { return tollAt(place); });
    _settlements = settlementsOn({_ground, _drainage, _settings.seed, free,
                                  [&](const glm::dvec2& place) { return search.isReachable(place); }});
    report.settlements = _settlements.size();
    report.unreached = planRoads(_settlements, search, _web);
    if (_web.ways().empty() && !_settlements.empty())
        report.unreached =
            roadThrough(_settlements.front().middle, _ground.box(), "tertiary", search, _web) ? 0 : 1;
    if (airfield) joinToWeb(airfield->gate(), "tertiary", search, _web);
    _web.weave();
    const StreetRules rules{_ground, free, _settings.seed};
    for (std::size_t i = 0; i < _settlements.size(); ++i)
        growStreets(_settlements[i], static_cast<int>(i), rules, _web);
    _web.weave();
}

void MadeUpLand::buildHouses()
{
    const auto isDry = [&](const glm::dvec2& place) { return isFree(place) && !_brooks.contains(place); };
    const PlotRules rules{_ground, _web, isDry, _settings.seed};
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
            parts.push_back(PlanArea(_plots.all()[plot]).grown(kPlotGardenM));
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

} // namespace worldmaking
