// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/roam/GroundRay.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "RealData.h"
#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::Random;

const viewlod::Frustum kEverywhere(glm::dmat4(0.0)); // planes without direction cull nothing

/// Some 400 km of sea with swell and islands, `depthM` below the ellipsoid; the southern edge at 46° north.
std::shared_ptr<const RoamTile> sea(double depthM)
{
    HeightField field = testsupport::hills(257, 257, 1560.0);
    for (float& h : field.heightsM)
        h = std::max(0.5f * h - 290.0f, 0.002f * h) - static_cast<float>(depthM);
    GeodeticNet net;
    net.step = 4;
    net.nodesPerSide = 256 / net.step + 1;
    for (int b = 0; b < net.nodesPerSide; ++b)
        for (int a = 0; a < net.nodesPerSide; ++a)
            net.nodes.push_back({46.0 + 0.014 * b * net.step, 8.0 + 0.02 * a * net.step, 0.0});
    field.net = net;
    return std::make_shared<const RoamTile>(PlacedTile(std::move(field)));
}

viewlod::ViewState viewFrom(const glm::dvec3& eye)
{
    viewlod::ViewState view;
    view.eyeWorld = eye;
    view.pixelsPerTangent = 1000.0;
    view.nearM = 1.0;
    return view;
}

glm::dvec3 eyeAbove(const PlacedTile& tile, double column, double row, double aboveM)
{
    const int c = static_cast<int>(column), r = static_cast<int>(row);
    const double ground = std::max({tile.samples().heightM(c, r), tile.samples().heightM(c + 1, r),
                                    tile.samples().heightM(c, r + 1), tile.samples().heightM(c + 1, r + 1)});
    return tile.frame().positionAt(column, row, ground + aboveM);
}

/// Whether every region around a sample is left out.
bool isHidden(const RegionBounds& regions, const std::vector<bool>& isSeen, int column, int row)
{
    for (const GridPoint step : {GridPoint{2, 1}, GridPoint{1, 2}, GridPoint{-2, 1}, GridPoint{-1, 2}})
        for (const int side : {-1, 1})
            if (isSeen[regions.pathAt({4 * column + side * step.column, 4 * row + side * step.row})])
                return false;
    return true;
}

struct Findings
{
    int eyes = 0, hidden = 0, wrong = 0; ///< eyes with a horizon, samples left out, those that can be seen
};

/// Looks for samples that are left out although a straight line leads to them. `mutate`: changes what is
/// known to hide.
template<class Mutate>
Findings bruteForce(const std::shared_ptr<const RoamTile>& tile, int eyes, int samples, const Mutate& mutate)
{
    Findings found;
    Random random(23);
    const PlacedTile& placed = tile->tile;
    HidingGround ground = tile->hidingGround;
    mutate(ground);
    for (int i = 0; i < eyes; ++i)
    {
        // A third of them close to an edge.
        const double columns = placed.grid().dataColumns() - 1.01, rows = placed.grid().dataRows() - 1.01;
        const double column = columns * random.unit(), away = i % 3 == 0 ? 0.001 : 1.0;
        const double row = i % 2 == 0 ? rows * away * random.unit() : rows * (1.0 - away * random.unit());
        const glm::dvec3 eye = eyeAbove(placed, column, row, 2.0 * std::pow(5000.0, random.unit()));
        const auto horizon = Horizon::around(placed, ground, eye, 1e-3, 1.0);
        if (!horizon) continue;
        ++found.eyes;
        std::vector<std::uint32_t> regions;
        tile->regions.visible(kEverywhere, &*horizon, regions);
        std::vector<bool> isSeen(tile->regions.regionCount(), false);
        for (const std::uint32_t region : regions)
            isSeen[region] = true;
        for (int k = 0; k < samples; ++k)
        {
            const int c = 1 + static_cast<int>(
                                  random.below(static_cast<std::uint32_t>(placed.grid().dataColumns() - 2)));
            int r =
                1 + static_cast<int>(random.below(static_cast<std::uint32_t>(placed.grid().dataRows() - 2)));
            if (away < 1.0 && k % 2 == 0)
                r = row < 0.5 * rows ? 1 : placed.grid().dataRows() - 2; // along the edge
            if (!isHidden(tile->regions, isSeen, c, r)) continue;
            ++found.hidden;
            const glm::dvec3 way = placed.position(c, r) - eye;
            const double distance = glm::length(way);
            if (!hitGround(*tile, eye, way / distance, distance - 1.0)) ++found.wrong;
        }
    }
    return found;
}

const auto kAsItIs = [](HidingGround&) {};

TEST(Horizon, NothingThatCanBeSeenIsLeftOut)
{
    for (const double depthM : {0.0, 400.0, -1500.0})
    {
        const Findings found = bruteForce(sea(depthM), 120, 300, kAsItIs);
        EXPECT_EQ(found.wrong, 0) << depthM;
        EXPECT_GT(found.eyes, 80);
        EXPECT_GT(found.hidden, 3000);
    }
}

TEST(Horizon, GroundThatIsHigherThanItShouldBeHidesTooMuch)
{
    const Findings found =
        bruteForce(sea(0.0), 120, 300, [](HidingGround& ground) { ground.lowestM += 250.0; });
    EXPECT_GT(found.wrong, 5); // an eye 700 m high has its horizon 20 % nearer
}

TEST(Horizon, GroundBeyondTheEdgeOfTheDataHidesTooMuch)
{
    // The way over the ball leads over the data's edge, northwards of the parallel, and there is nothing to
    // hide behind.
    const Findings found = bruteForce(sea(0.0), 120, 300,
                                      [](HidingGround& ground)
                                      {
                                          for (glm::dvec4& wall : ground.walls)
                                              wall.w += 20e3;
                                      });
    EXPECT_GT(found.wrong, 0);
}

TEST(Horizon, OnRealTerrainNothingThatCanBeSeenIsLeftOut)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem");
    int hidden = 0;
    for (const char* file : {"N44W072.hgt", "N49W124.tif", "N57E011.hgt"})
    {
        const auto field = importDem(folder / file);
        ASSERT_TRUE(field) << field.error().message();
        const auto tile = std::make_shared<const RoamTile>(PlacedTile(*field));
        const Findings found = bruteForce(tile, 40, 200, kAsItIs);
        EXPECT_EQ(found.wrong, 0) << file;
        hidden += found.hidden;
    }
    EXPECT_GT(hidden, 100);
}

TEST(Horizon, IsWhereGeometryHasIt)
{
    const auto tile = sea(0.0);
    const glm::dvec3 eye = tile->tile.frame().positionAt(128.5, 128.5, 300.0);
    const auto horizon = Horizon::around(tile->tile, tile->hidingGround, eye, 0.0, 1.0);
    ASSERT_TRUE(horizon);
    EXPECT_NEAR(horizon->distanceM(), std::sqrt(2.0 * 6371e3 * 300.0), 1000.0);
    const auto far = [&](double north)
    { return tile->tile.frame().positionAt(128.5, 128.5 + north / 1557.0, 0.0); };
    EXPECT_FALSE(horizon->hides(far(60e3), 10.0, 0.0)); // the horizon is at 61.8 km
    EXPECT_TRUE(horizon->hides(far(90e3), 10.0, 0.0));
    EXPECT_FALSE(
        horizon->hides(far(90e3), 10.0, 200.0)); // and a mountain of 60 m is seen as far again as 28 km
    EXPECT_FALSE(horizon->hides(far(90e3), 40e3, 0.0));
}

TEST(Horizon, IsNoneForEyesThatItDoesNotHoldFor)
{
    const auto tile = sea(0.0);
    const auto around = [&](double column, double row, double heightM, double errorPerM)
    {
        return Horizon::around(tile->tile, tile->hidingGround,
                               tile->tile.frame().positionAt(column, row, heightM), errorPerM, 1.0)
            .has_value();
    };
    EXPECT_TRUE(around(100, 100, 300, 1e-3));
    EXPECT_FALSE(around(-1, 100, 300, 1e-3)) << "beside the data";
    EXPECT_FALSE(around(100, 100, 30e3, 1e-3)) << "too high";
    EXPECT_FALSE(around(100, 100, -600, 1e-3)) << "under ground";
    EXPECT_FALSE(around(100, 100, 300, 0.5)) << "drawn too coarsely";
    EXPECT_FALSE(testsupport::planarTile(testsupport::hills(33, 33))->hidingGround.exists);
}

TEST(Horizon, LeavesOutMostOfASeaAndNothingForAnotherEye)
{
    const auto tile = sea(0.0);
    for (const double heightM : {2.0, 300.0})
    {
        const glm::dvec3 eye = eyeAbove(tile->tile, 128.5, 128.5, heightM);
        RoamMesh mesh(tile);
        mesh.refine(viewFrom(eye), {.errorTolerancePx = 0.1});
        const auto horizon = mesh.horizon(eye);
        ASSERT_TRUE(horizon);
        std::vector<TriangleRange> all, above;
        const std::uint32_t triangles = mesh.visibleRanges(kEverywhere, all);
        EXPECT_EQ(mesh.visibleRanges(kEverywhere, eye, nullptr, all), triangles);
        const std::uint32_t seen = mesh.visibleRanges(kEverywhere, eye, &*horizon, above);
        EXPECT_LT(seen, triangles * (heightM < 100.0 ? 0.3 : 0.6)) << heightM;
        EXPECT_FALSE(mesh.horizon(eye + glm::dvec3(1.0, 0.0, 0.0)));
        mesh.refine(1.0);
        EXPECT_FALSE(mesh.horizon(eye));
    }
}

} // namespace
