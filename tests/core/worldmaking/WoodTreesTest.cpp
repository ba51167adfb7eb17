// SPDX-License-Identifier: Apache-2.0
// Wherever the ground is wood, an eye 50 m up sees trees for a kilometre: no wood is painted where no tree
// stands.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <osgRoads/core/network/RoadNetwork.h>

#include "worldmaking/land/LandUse.h"
#include "worldmaking/land/Trees.h"
#include "worldmaking/madeup/MadeUpMap.h"

namespace
{

using namespace worldmaking;

constexpr double kSeenM = 1000.0, kEyeM = 50.0;

/// A plain that rises to hills.
std::optional<double> risingGround(double latitudeDeg, double longitudeDeg)
{
    const double north = (latitudeDeg - 46.0) * 111320.0, east = (longitudeDeg - 8.0) * 77330.0;
    return 300.0 + 0.1 * std::max(north, 0.0) + 12.0 * std::sin(east / 500.0) * std::min(1.0, north / 2000.0);
}

/// Trees of a plane, found by squares.
class TreeFinder
{
public:
    explicit TreeFinder(const std::vector<Tree>& trees)
    {
        for (std::size_t i = 0; i < trees.size(); ++i)
        {
            _places.push_back(trees[i].place);
            _grid.add(i, {trees[i].place, trees[i].place});
        }
    }

    bool hasWithin(const glm::dvec2& place, double metres) const
    {
        bool has = false;
        _grid.near({place - metres, place + metres},
                   [&](std::size_t i) { has = has || glm::distance(_places[i], place) <= metres; });
        return has;
    }

private:
    std::vector<glm::dvec2> _places;
    PlanGrid _grid;
};

/// The wood texels within a kilometre of eyes over woods, and how many of them have no tree near by.
struct Seen
{
    std::size_t eyes = 0, woods = 0, bare = 0;
};

Seen seenFrom(const CoverRaster& cover, const TreeFinder& trees, double nearM)
{
    Seen seen;
    const MapBox& box = cover.box();
    for (double north = box.low.y; north < box.high.y; north += 700.0)
        for (double east = box.low.x; east < box.high.x; east += 700.0)
        {
            const glm::dvec2 eye(east, north);
            if (cover.at(eye) != Cover::trees) continue;
            ++seen.eyes;
            for (double dy = -kSeenM; dy <= kSeenM; dy += 20.0)
                for (double dx = -kSeenM; dx <= kSeenM; dx += 20.0)
                {
                    const glm::dvec2 place = eye + glm::dvec2(dx, dy);
                    if (std::hypot(dx, dy, kEyeM) > kSeenM || cover.at(place) != Cover::trees) continue;
                    ++seen.woods;
                    seen.bare += !trees.hasWithin(place, nearM);
                }
        }
    return seen;
}

TEST(WoodTrees, AnEyeOverAWoodSeesTreesForAKilometre)
{
    MadeUpSettings settings;
    settings.bounds = {7.94, 45.97, 8.06, 46.05};
    const auto made = makeUpMap(risingGround, settings);
    ASSERT_TRUE(made) << made.error().message();
    const auto plane = MapPlane::create(planeAbout(made->land), "made");
    ASSERT_TRUE(plane);
    const osgRoads::core::RoadNetwork none;
    const RoadRoom room(none);
    LandReport land;
    const CoverRaster cover = coverRasterOf(made->land, *plane, std::nullopt, land);
    TreeReport report;
    const foundation::HeightInPlan height = [](const glm::dvec2&) { return std::optional<double>(400.0); };
    std::vector<Tree> trees = treesOf(made->land, *plane, {room, cover, {}, {}}, height, report);
    const double nearM = 2.0 * report.spacingM;
    const Seen seen = seenFrom(cover, TreeFinder(trees), nearM);
    EXPECT_GT(seen.eyes, 5u);
    EXPECT_GT(seen.woods, 5000u);
    EXPECT_LE(static_cast<double>(seen.bare), 1e-3 * static_cast<double>(seen.woods));
    // The control: a clearing of 400 m that is still painted as wood.
    const glm::dvec2 clearing = trees[trees.size() / 2].place;
    std::erase_if(trees, [&](const Tree& tree) { return glm::distance(tree.place, clearing) < 200.0; });
    const Seen cleared = seenFrom(cover, TreeFinder(trees), nearM);
    EXPECT_GT(static_cast<double>(cleared.bare), 1e-3 * static_cast<double>(cleared.woods));
}

TEST(WoodTrees, NoneStandsWhereThereIsNoGround)
{
    const LandMap map{{{1,
                        ShapeForm::area,
                        {{{8.0, 46.0}, {8.01, 46.0}, {8.01, 46.01}, {8.0, 46.01}}},
                        {{"natural", "wood"}}}},
                      0};
    const auto plane = MapPlane::create(planeAbout(map), "made");
    ASSERT_TRUE(plane);
    const osgRoads::core::RoadNetwork none;
    const RoadRoom room(none);
    LandReport land;
    const CoverRaster cover = coverRasterOf(map, *plane, std::nullopt, land);
    const auto eastmost = [&](const foundation::HeightInPlan& height)
    {
        TreeReport report;
        double east = -1e9;
        for (const Tree& tree : treesOf(map, *plane, {room, cover, {}, {}}, height, report))
            east = std::max(east, tree.place.x);
        return east;
    };
    const double middle = 0.5 * (cover.box().low.x + cover.box().high.x);
    EXPECT_LT(eastmost([&](const glm::dvec2& place)
                       { return place.x < middle ? std::optional(400.0) : std::nullopt; }),
              middle);
    EXPECT_GT(eastmost([](const glm::dvec2&) { return std::optional(400.0); }), middle + 300.0);
}

} // namespace
