// SPDX-License-Identifier: Apache-2.0
// The stages of MadeUpLand that use what settlements leave: fields, hedges, avenues, woods.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <foundation/ForEachAtOnce.h>

#include "worldmaking/madeup/MadeUpLand.h"
#include "worldmaking/madeup/Parcels.h"
#include "worldmaking/madeup/Woods.h"
#include "worldmaking/plan/Noise.h"

namespace worldmaking
{

namespace
{

using scenery::models::Dice;

constexpr double kFarmReachM = 2600.0; ///< of settlements: fields beyond are few
constexpr double kWoodBalkM = 2.0;     ///< between a field and a wood
constexpr std::size_t kMostHedges = 260;

} // namespace

double MadeUpLand::farmWish(const glm::dvec2& place) const
{
    double away = 1e9;
    for (const Settlement& settlement : _settlements)
        away = std::min(away, glm::distance(settlement.middle, place) - settlement.radiusM());
    const double near = std::clamp(1.0 - away / kFarmReachM, -0.6, 1.0);
    const double high = std::max(0.0, *_ground.heightM(place) - 0.6 * _treeLineM) / 300.0;
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
        for (const auto& piece : piecesOf(line))
        {
            const MapBox box = boxOf(piece);
            take(PlanArea::around(piece, radiusM), {box.low - radiusM, box.high + radiusM});
        }
    };
    for (const MadeWay& way : _web.ways())
        takeLine(way.points, way.halfWidthM() + 6.0);
    for (const Stream& stream : _streams)
        takeLine(stream.points, 0.5 * stream.widthM() + 8.0);
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
    std::vector<PlanRings> fields = parcelsOn(rules), grown(fields.size());
    foundation::forEachAtOnce(fields.size(),
                              [&](std::size_t i) { grown[i] = grownRings(fields[i], kWoodBalkM); });
    for (std::size_t number = 1; number <= fields.size(); ++number)
    {
        PlanRings& field = fields[number - 1];
        addHedges(field, number);
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
        _tilled.add(std::move(grown[number - 1]));
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
    rules.treeLineM = _treeLineM;
    rules.seed = _settings.seed;
    for (PlanRings& wood : woodsOn(rules))
    {
        shapes.push_back(areaShape(std::move(wood), {{"natural", "wood"}}));
        ++report.woods;
    }
}

} // namespace worldmaking
