// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/check/ErrorCheck.h>
#include <osgMultiTriangulation/core/check/SurfaceCheck.h>
#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/follow/DrawnSurfaceCheck.h>
#include <osgMultiTriangulation/core/follow/SampledSurface.h>
#include <osgMultiTriangulation/core/follow/SurfaceFollower.h>

#include "HillSurface.h"
#include "TestFolder.h"

namespace osgMultiTriangulation::core
{

namespace
{

constexpr double kVertexStep = 1.0 / 1024.0;
constexpr double kErrorPerDistance = 0.02;

/// Hills of 120 × 100 points, 10 m apart, in a file of 16 rectangles.
struct HillsOfTenMetres
{
    testsupport::TestFolder folder{"follower"};
    SurfaceMesh mesh = testsupport::hillSurface(120, 100);
    std::filesystem::path path = folder / "hills.mt";
    PlanFrame frame{1000.0, 2000.0, 10.0, 10.0};

    HillsOfTenMetres()
    {
        ForestOptions options;
        options.treeCount = 16;
        EXPECT_TRUE(buildMtFile(mesh, frame, options, path));
    }

    std::unique_ptr<SurfaceFollower> follower(std::size_t memory = 20'000'000, double bytesPerS = 1e12) const
    {
        ZoneSettings settings;
        settings.memoryBytes = memory;
        settings.mostBytesPerS = bytesPerS;
        auto opened = SurfaceFollower::open(*MtFile::open(path), settings, kVertexStep);
        EXPECT_TRUE(opened);
        return std::move(*opened);
    }
};

FollowTarget targetAt(double share)
{
    return {
        {1190.0 * share, 900.0 * (1.0 - share), 90.0 + 50.0 * std::sin(9.0 * share)}, kErrorPerDistance, 1.0};
}

void expectSound(const DrawnSurface& surface, const SurfaceFollower& follower,
                 const std::vector<OutlineSide>& outline)
{
    EXPECT_EQ(checkDrawn(surface, follower.frame(), outline), std::nullopt);
}

/// By how much, in metres, a point is farther from the surface than `allowed` times what the target allows at
/// the distance of its triangle.
double excessOf(const DrawnSurface& surface, const DrawnFrame& frame, const PointCells& points,
                const FollowTarget& target, double allowed)
{
    const SurfaceMesh mesh = latticeMeshOf(surface, frame);
    std::vector<float> bounds;
    for (const Triangle& triangle : mesh.triangles)
    {
        glm::dvec3 low(1e30), high(-1e30);
        for (const std::uint32_t corner : triangle)
        {
            const SurfacePoint& p = mesh.points[corner];
            low = glm::min(low, glm::dvec3(10.0 * p.x, 10.0 * p.y, p.height));
            high = glm::max(high, glm::dvec3(10.0 * p.x, 10.0 * p.y, p.height));
        }
        const double distance =
            glm::length(glm::max(glm::max(low - target.eye, target.eye - high), glm::dvec3(0.0)));
        bounds.push_back(
            static_cast<float>(allowed * target.errorPerDistance * std::max(distance, target.nearest)));
    }
    return points.greatestExcess(mesh, bounds);
}

TEST(SurfaceFollower, settledSurfacesAreTriangulationsWithinTheToleranceByBruteForce)
{
    const HillsOfTenMetres here;
    const auto follower = here.follower();
    const PointCells points(here.mesh.points);
    const std::vector<OutlineSide> outline = outlineOf(here.mesh);
    const std::size_t view = follower->addView();
    double worstOfAThird = -1e30;
    for (int step = 0; step < 30; ++step)
    {
        const FollowTarget target = targetAt(step / 30.0);
        const auto surface = follower->settle(view, target);
        expectSound(*surface, *follower, outline);
        EXPECT_LE(excessOf(*surface, follower->frame(), points, target, 1.0), 1e-3) << step;
        worstOfAThird =
            std::max(worstOfAThird, excessOf(*surface, follower->frame(), points, target, 1.0 / 3.0));
        EXPECT_LE(seenErrorPerDistance(*surface, follower->frame(), target.eye, target.nearest),
                  1.001 * kErrorPerDistance);
        EXPECT_LT(surface->triangles.size(), here.mesh.triangles.size() / 3);
        EXPECT_GT(surface->triangles.size(), 100u);
    }
    EXPECT_GT(worstOfAThird, 0.1) << "a check that passes with a third of the tolerance checks nothing";
}

TEST(DrawnSurfaceCheck, findsWhatIsDamaged)
{
    const HillsOfTenMetres here;
    const auto follower = here.follower();
    const std::vector<OutlineSide> outline = outlineOf(here.mesh);
    const DrawnSurface sound = *follower->settle(follower->addView(), targetAt(0.5));
    expectSound(sound, *follower, outline);
    const auto isFound = [&](const auto& damage)
    {
        DrawnSurface surface = sound;
        damage(surface);
        return checkDrawn(surface, follower->frame(), outline).has_value();
    };
    EXPECT_TRUE(isFound([](DrawnSurface& s) { s.vertices[s.vertices.size() / 2][0] += 40 * 1024; }));
    EXPECT_TRUE(isFound([](DrawnSurface& s) { s.triangles[7] = s.triangles[8]; }));
    EXPECT_TRUE(isFound([](DrawnSurface& s) { s.cells[3].high.z = s.cells[3].low.z; }));
    EXPECT_TRUE(isFound([](DrawnSurface& s) { --s.cells.back().triangles; }));
    EXPECT_TRUE(isFound([](DrawnSurface& s) { ++s.cells[2].firstTriangle; }));
    EXPECT_GT(seenErrorPerDistance(sound, follower->frame(), targetAt(0.9).eye, 1.0),
              1.5 * kErrorPerDistance);
}

TEST(SurfaceFollower, equalFlightsGiveEqualSurfaces)
{
    const HillsOfTenMetres here;
    const auto one = here.follower(), other = here.follower();
    one->addView();
    other->addView();
    for (int step = 0; step < 20; ++step)
    {
        const auto a = one->settle(0, targetAt(step / 20.0)), b = other->settle(0, targetAt(step / 20.0));
        EXPECT_EQ(a->vertices, b->vertices);
        EXPECT_EQ(a->triangles, b->triangles);
    }
}

TEST(SurfaceFollower, aSurfaceIsThereAtOnceAndDetailFollowsWithoutAHole)
{
    const HillsOfTenMetres here;
    const FollowTarget target = targetAt(0.4);
    const auto direct = here.follower();
    direct->addView();
    const std::size_t triangles = direct->settle(0, target)->triangles.size();

    const auto follower = here.follower(20'000'000, 2e6); // slow, so that surfaces between are made
    const std::vector<OutlineSide> outline = outlineOf(here.mesh);
    const std::size_t view = follower->addView();
    std::shared_ptr<const DrawnSurface> drawn;
    // However slow this machine is: the test ends when all detail is there, or fails after a minute.
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while ((!drawn || drawn->triangles.size() != triangles) && std::chrono::steady_clock::now() < end)
    {
        const auto surface = follower->follow(view, target);
        if (!surface) continue; // it is just being changed
        if (!drawn)
        {
            EXPECT_EQ(surface->serial, follower->coarsest()->serial);
        }
        if (!drawn || drawn->serial != surface->serial) expectSound(*surface, *follower, outline);
        drawn = surface;
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    EXPECT_EQ(drawn->triangles.size(), triangles);
    EXPECT_GT(follower->figures().surfaces, 3u);
    EXPECT_EQ(follower->settle(view, target)->triangles.size(), triangles);
}

TEST(SurfaceFollower, viewsComeAndGoWithinTheMemory)
{
    const HillsOfTenMetres here;
    constexpr std::size_t kMemory = 900'000;
    const auto follower = here.follower(kMemory);
    const std::vector<OutlineSide> outline = outlineOf(here.mesh);
    const std::size_t first = follower->addView();
    for (int round = 0; round < 6; ++round)
    {
        const std::size_t second = follower->addView(), third = follower->addView();
        for (const std::size_t view : {first, second, third})
        {
            expectSound(*follower->settle(view, targetAt(0.1 * round + 0.2 * static_cast<double>(view))),
                        *follower, outline);
            EXPECT_LE(follower->figures().memoryBytes, kMemory);
        }
        follower->removeView(second);
        follower->removeView(third);
        follower->settle(first, targetAt(0.15 * round + 0.03));
        EXPECT_EQ(follower->figures().views, 1u);
    }
}

TEST(SurfaceFollower, aDamagedTreeIsCoarserAndNoHole)
{
    const HillsOfTenMetres here;
    std::string bytes = testsupport::bytesOf(here.path);
    const std::size_t last = MtFile::open(here.path)->info().trees.back().offset + 30;
    bytes[last] = static_cast<char>(bytes[last] ^ 1);
    std::ofstream(here.path, std::ios::binary) << bytes;
    const auto follower = here.follower();
    follower->addView();
    for (const double share : {0.1, 0.5, 0.9})
        expectSound(*follower->settle(0, targetAt(share)), *follower, outlineOf(here.mesh));
    EXPECT_LE(follower->figures().faults.size(), 1u);
    FollowTarget everywhere = targetAt(0.5);
    everywhere.errorPerDistance = 0.0;
    expectSound(*follower->settle(0, everywhere), *follower, outlineOf(here.mesh));
    EXPECT_EQ(follower->figures().faults.size(), 1u);
}

TEST(SampledSurface, isTheInputWhereTheLatticeIsTheGrid)
{
    const HillsOfTenMetres here;
    const auto sampled = sampleSurface(*MtFile::open(here.path));
    ASSERT_TRUE(sampled);
    ASSERT_EQ(sampled->columns, 120);
    ASSERT_EQ(sampled->rows, 100);
    EXPECT_EQ(sampled->spacingX, 10.0);
    for (std::size_t i = 0; i < here.mesh.points.size(); ++i)
        ASSERT_EQ(sampled->heights[i], static_cast<float>(here.mesh.points[i].height)) << i;
    EXPECT_EQ(std::ranges::count(sampled->isThere, 1), 120 * 100);
}

TEST(SampledSurface, isNearTheInputOnACoarserGrid)
{
    const HillsOfTenMetres here;
    const auto sampled = sampleSurface(*MtFile::open(here.path), 41);
    ASSERT_TRUE(sampled);
    EXPECT_EQ(sampled->columns, 41);
    EXPECT_EQ(sampled->rows, 34);
    for (int row = 0; row < sampled->rows; ++row)
        for (int column = 0; column < sampled->columns; ++column)
        {
            const auto at = [](int i, double pitch, int most)
            { return std::min(static_cast<int>(std::lround(i * pitch / 10.0)), most); };
            const std::size_t nearest =
                at(row, sampled->spacingY, 99) * 120 + at(column, sampled->spacingX, 119);
            EXPECT_NEAR(sampled->heights[row * 41 + column], here.mesh.points[nearest].height, 12.0);
        }
}

} // namespace

} // namespace osgMultiTriangulation::core
