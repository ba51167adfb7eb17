// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/Trees.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unordered_map>
#include <utility>

#include <foundation/NearestOnSegment.h>
#include <foundation/Random.h>

#include "scenery/buildings/Outline.h"
#include "scenery/models/Dice.h"
#include "worldmaking/land/LandUse.h"
#include "worldmaking/land/MapFile.h"
#include "worldmaking/land/ModelPoints.h"
#include "worldmaking/plan/Waters.h"
#include "worldmaking/streets/PathTags.h"

namespace worldmaking
{

namespace
{

using scenery::models::Dice;

constexpr double kSpacingM = 11.0, kRowM = 9.0, kHedgeM = 1.8, kOrchardM = 6.0, kShrubM = 18.0;
constexpr double kGardenM = 15.0, kGardenTrees = 0.4, kGardenBushes = 0.4; ///< one square holds one or none
constexpr double kModelRoomM = 9.0; ///< from the middle of a house or car that is a model
constexpr double kPathRoomM = 2.0;  ///< from the middle of a path
constexpr double kSpruceFromM = 1500.0;

double distanceM(const glm::dvec2& place, const std::vector<glm::dvec2>& ring)
{
    double least = 1e300;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        least = std::min(least, glm::length(place - a - foundation::nearestShare(place, a, b) * (b - a)));
    }
    return least;
}

std::uint64_t seedOf(std::int64_t column, std::int64_t row)
{
    return static_cast<std::uint64_t>(column) * foundation::SplitMix64::kStep ^
           (static_cast<std::uint64_t>(row) << 21U);
}

/// Puts trees where there is room.
class Planter
{
public:
    Planter(const LandMap& map, const MapPlane& plane, const TakenGround& taken,
            const foundation::HeightInPlan& height)
        : _taken(taken), _height(height), _waters(map, plane)
    {
        for (std::size_t i = 0; i < taken.houses.size(); ++i)
        {
            MapBox box = boxOf(taken.houses[i].building.rings.front());
            _houses.add(i, {box.low - kWallRoomM, box.high + kWallRoomM});
        }
        for (std::size_t i = 0; i < taken.runways.size(); ++i)
            _runways.add(i, boxOf(taken.runways[i].front()));
    }

    bool plant(const glm::dvec2& place, std::string_view leaf, std::string_view bush, Dice& dice)
    {
        if (!isFree(place)) return false;
        Tree tree{place, {}, 1 + dice.below(2), dice.between(0.75, 1.15)};
        if (!bush.empty())
        {
            tree.kind = bush;
            tree.seed = 1;
            tree.scale = dice.between(0.5, 0.9);
        }
        else
            tree.kind = kindAt(place, leaf, dice);
        trees.push_back(tree);
        return true;
    }

    std::vector<Tree> trees;

private:
    bool isFree(const glm::dvec2& place) const
    {
        if (_taken.cover.at(place) == Cover::water || _waters.contain(place)) return false;
        bool isFree = true;
        _houses.near({place, place},
                     [&](std::size_t i)
                     {
                         const auto& rings = _taken.houses[i].building.rings;
                         isFree = isFree && !scenery::isWithin(rings, place) &&
                                  distanceM(place, rings.front()) >= kWallRoomM;
                     });
        _runways.near({place, place}, [&](std::size_t i)
                      { isFree = isFree && !scenery::isWithin(_taken.runways[i], place); });
        return isFree && _taken.roads.distanceM(place, kTreeRoomM) >= kTreeRoomM && _height(place);
    }

    /// The height by squares of 200 m is exact enough for a kind.
    bool isHigh(const glm::dvec2& place)
    {
        const glm::dvec2 cell = glm::floor(place / 200.0);
        const auto key = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.x)) << 32U ^
                         static_cast<std::uint32_t>(static_cast<std::int64_t>(cell.y));
        const auto [found, isNew] = _isHigh.try_emplace(key, false);
        if (isNew) found->second = _height(200.0 * (cell + 0.5)).value_or(0.0) > kSpruceFromM;
        return found->second;
    }

    std::string_view kindAt(const glm::dvec2& place, std::string_view leaf, Dice& dice)
    {
        const double share = dice.unit();
        const double spruces = leaf == "needleleaved"  ? 0.97
                               : leaf == "broadleaved" ? 0.03
                                                       : (isHigh(place) ? 0.85 : 0.35);
        if (share < spruces) return "spruce";
        return share < spruces + 0.7 * (1.0 - spruces) ? "oak" : "birch";
    }

    const TakenGround& _taken;
    const foundation::HeightInPlan& _height;
    Waters _waters;
    PlanGrid _houses, _runways;
    std::unordered_map<std::uint64_t, bool> _isHigh;
};

/// Calls `use(place, dice)` for a place in each square of a grid over a box.
template<class Use>
void overGrid(const MapBox& box, double sideM, const Use& use)
{
    const auto at = [&](double metres) { return static_cast<std::int64_t>(std::floor(metres / sideM)); };
    for (std::int64_t row = at(box.low.y); row <= at(box.high.y); ++row)
        for (std::int64_t column = at(box.low.x); column <= at(box.high.x); ++column)
        {
            Dice dice(seedOf(column, row));
            const double east = (static_cast<double>(column) + dice.between(0.1, 0.9)) * sideM;
            use(glm::dvec2(east, (static_cast<double>(row) + dice.between(0.1, 0.9)) * sideM), dice);
        }
}

/// Calls `use(place)` for places along a line, `stepM` apart.
template<class Use>
void alongLine(const std::vector<glm::dvec2>& line, double stepM, const Use& use)
{
    double left = 0.5 * stepM;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
        const double lengthM = glm::length(line[i + 1] - line[i]);
        for (; left < lengthM; left += stepM)
            use(glm::mix(line[i], line[i + 1], left / lengthM));
        left -= lengthM;
    }
}

/// Plants what the map names one by one: rows, hedges, orchards, single trees.
void plantShape(const LandShape& shape, const MapPlane& plane, Planter& planter, TreeReport& report)
{
    const auto paths = plane.toPlan(shape.paths);
    if (!paths) return;
    const auto& tags = shape.tags;
    const auto leaf = valueOf(tags, "leaf_type"), natural = valueOf(tags, "natural"),
               use = valueOf(tags, "landuse");
    Dice dice(static_cast<std::uint64_t>(shape.id));
    if (shape.form == ShapeForm::point && natural == "tree")
        report.single += planter.plant(paths->front().front(), leaf, {}, dice);
    else if (shape.form == ShapeForm::line && natural == "tree_row")
        alongLine(paths->front(), kRowM,
                  [&](const glm::dvec2& place) { report.inRows += planter.plant(place, leaf, {}, dice); });
    else if (shape.form == ShapeForm::line && valueOf(tags, "barrier") == "hedge")
        alongLine(paths->front(), kHedgeM,
                  [&](const glm::dvec2& place)
                  { report.hedges += planter.plant(place, leaf, "bush", dice); });
    else if (shape.form == ShapeForm::area && (use == "orchard" || use == "vineyard"))
    {
        const MapBox box = boxOf(paths->front());
        for (double north = box.low.y; north < box.high.y; north += kOrchardM)
            for (double east = box.low.x; east < box.high.x; east += kOrchardM)
                if (const glm::dvec2 place(east, north); scenery::isWithin(*paths, place))
                    report.inOrchards += planter.plant(place, leaf, "bush", dice);
    }
}

/// What trees of gardens keep away from beside what all trees do: squares, parking places and other yards,
/// paths, houses and cars that are models.
class GardenLimits
{
public:
    GardenLimits(const LandMap& map, const MapPlane& plane)
    {
        for (const LandShape& shape : map.shapes)
        {
            const bool isYard = shape.form == ShapeForm::area && coverOf(shape.tags) == Cover::yard,
                       isPath = shape.form == ShapeForm::line && isFootway(shape.tags),
                       isModel = namesModel(shape);
            const auto paths = isYard || isPath || isModel ? plane.toPlan(shape.paths) : std::nullopt;
            if (!paths || paths->empty()) continue;
            if (isYard)
                add({*paths, 0.0}, boxOf(paths->front()));
            else if (isModel)
                add({*paths, kModelRoomM}, boxOf(paths->front()));
            else
                for (std::size_t i = 0; i + 1 < paths->front().size(); ++i)
                {
                    const std::vector<glm::dvec2> piece{paths->front()[i], paths->front()[i + 1]};
                    add({{piece}, kPathRoomM}, boxOf(piece));
                }
        }
    }

    bool keepFree(const glm::dvec2& place) const
    {
        bool isKept = false;
        _grid.near({place, place},
                   [&](std::size_t i)
                   {
                       const Limit& limit = _limits[i];
                       isKept =
                           isKept || (limit.roomM > 0.0 ? distanceM(place, limit.paths.front()) < limit.roomM
                                                        : scenery::isWithin(limit.paths, place));
                   });
        return isKept;
    }

private:
    struct Limit
    {
        PlanRings paths;
        double roomM; ///< 0: within the rings
    };

    void add(Limit limit, const MapBox& box)
    {
        _grid.add(_limits.size(), {box.low - limit.roomM, box.high + limit.roomM});
        _limits.push_back(std::move(limit));
    }

    std::vector<Limit> _limits;
    PlanGrid _grid;
};

/// Plants gardens: a tree, a bush or nothing in each square of a grid.
void plantGardens(const LandMap& map, const MapPlane& plane, const CoverRaster& cover, Planter& planter,
                  TreeReport& report)
{
    const double gardensM2 =
        static_cast<double>(cover.count(Cover::garden)) * cover.texelM() * cover.texelM();
    const double sideM = std::max(kGardenM, std::sqrt(gardensM2 / static_cast<double>(kMostGardenPlants)));
    const GardenLimits limits(map, plane);
    overGrid(cover.box(), sideM,
             [&](const glm::dvec2& place, Dice& dice)
             {
                 const double draw = dice.unit();
                 if (draw > kGardenTrees + kGardenBushes || cover.at(place) != Cover::garden ||
                     limits.keepFree(place))
                     return;
                 const char* const bush = draw < kGardenTrees ? "" : "bush";
                 report.inGardens += planter.plant(place, "broadleaved", bush, dice);
             });
}

/// The leaves of the woods that say so, by place.
class Leaves
{
public:
    Leaves(const LandMap& map, const MapPlane& plane)
    {
        for (const LandShape& shape : map.shapes)
            if (shape.form == ShapeForm::area && !valueOf(shape.tags, "leaf_type").empty())
                if (auto rings = plane.toPlan(shape.paths))
                {
                    _grid.add(_woods.size(), boxOf(rings->front()));
                    _woods.emplace_back(std::move(*rings), valueOf(shape.tags, "leaf_type"));
                }
    }

    std::string_view at(const glm::dvec2& place) const
    {
        std::string_view leaf;
        _grid.near({place, place},
                   [&](std::size_t i)
                   {
                       if (leaf.empty() && scenery::isWithin(_woods[i].first, place)) leaf = _woods[i].second;
                   });
        return leaf;
    }

private:
    std::vector<std::pair<PlanRings, std::string_view>> _woods;
    PlanGrid _grid;
};

} // namespace

std::vector<Tree> treesOf(const LandMap& map, const MapPlane& plane, const TakenGround& taken,
                          const foundation::HeightInPlan& height, TreeReport& report)
{
    Planter planter(map, plane, taken, height);
    for (const LandShape& shape : map.shapes)
        plantShape(shape, plane, planter, report);
    const CoverRaster& cover = taken.cover;
    const double woodsM2 = static_cast<double>(cover.count(Cover::trees)) * cover.texelM() * cover.texelM();
    report.spacingM = std::max(kSpacingM, std::sqrt(woodsM2 / static_cast<double>(kMostTrees)));
    const Leaves leaves(map, plane);
    overGrid(cover.box(), report.spacingM,
             [&](const glm::dvec2& place, Dice& dice)
             {
                 if (cover.at(place) == Cover::trees)
                     report.inWoods += planter.plant(place, leaves.at(place), {}, dice);
             });
    overGrid(cover.box(), std::max(kShrubM, report.spacingM),
             [&](const glm::dvec2& place, Dice& dice)
             {
                 if (cover.at(place) == Cover::shrubs)
                     report.shrubs += planter.plant(place, {}, "bush", dice);
             });
    plantGardens(map, plane, cover, planter, report);
    return std::move(planter.trees);
}

foundation::Outcome writeTrees(std::span<const Tree> trees, const MapPlane& plane,
                               const std::filesystem::path& file)
{
    MapFile made(file);
    made.beginLayer("trees", ShapeForm::point, {"kind", "seed", "scale"});
    for (const Tree& tree : trees)
    {
        const auto degrees = plane.toDegrees(tree.place);
        if (!degrees) continue;
        char scale[16];
        std::snprintf(scale, sizeof scale, "%.2f", tree.scale);
        made.add({{*degrees}},
                 {{"kind", std::string(tree.kind)}, {"seed", std::to_string(tree.seed)}, {"scale", scale}});
    }
    return made.finish();
}

} // namespace worldmaking
