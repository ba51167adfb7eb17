// SPDX-License-Identifier: Apache-2.0
// The meter on shapes of known distance.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/simplify/SimplificationError.h>

#include "MadeMeshes.h"
#include "OrderMeshes.h"

namespace
{

using namespace osgPMObjects::core;

Mesh moved(Mesh mesh, const glm::dvec3& by)
{
    for (glm::dvec3& p : mesh.positions)
        p += by;
    return mesh;
}

Mesh scaled(Mesh mesh, double by)
{
    for (glm::dvec3& p : mesh.positions)
        p *= by;
    return mesh;
}

Mesh asMesh(const testsupport::IndexedMesh& indexed)
{
    return testsupport::meshOf(indexed.positions, indexed.triangles);
}

TEST(SimplificationMeter, FindsNothingBetweenAMeshAndItself)
{
    const Mesh sphere = asMesh(testsupport::sphereMesh(20, 40));
    const SimplificationMeter meter(sphere);
    const SimplificationError none = meter.measure(sphere);
    EXPECT_LT(none.meanPercent, 1e-12);
    EXPECT_LT(none.maxPercent, 1e-12);
    EXPECT_EQ(none.boxExcessPercent, 0.0);
    EXPECT_FALSE(none.drift);
    Mesh mutation = sphere;
    mutation.positions[17] *= 1.01;
    const SimplificationError some = meter.measure(mutation);
    EXPECT_GT(some.maxPercent, 0.2);
    EXPECT_GT(some.meanPercent, 1e-5);
}

TEST(SimplificationMeter, MeasuresTheDistanceOfTwoPlanesInPerCentOfTheDiagonal)
{
    const Mesh plane = testsupport::grid(3, 4); // its diagonal is 5
    const SimplificationError error = SimplificationMeter(plane).measure(moved(plane, {0.0, 0.0, 0.05}));
    EXPECT_NEAR(error.meanPercent, 1.0, 1e-9);
    EXPECT_NEAR(error.maxPercent, 1.0, 1e-9);
    EXPECT_NEAR(error.boxExcessPercent, 1.0, 1e-9);
}

TEST(SimplificationMeter, MeasuresTheDistanceOfTwoSpheres)
{
    const Mesh sphere = asMesh(testsupport::sphereMesh(90, 180));
    const double percent = 100.0 * 0.01 / (2.0 * std::sqrt(3.0));
    const SimplificationMeter meter(sphere);
    const SimplificationError larger = meter.measure(scaled(sphere, 1.01));
    EXPECT_NEAR(larger.meanPercent, percent, 0.01 * percent);
    EXPECT_NEAR(larger.maxPercent, percent, 0.01 * percent);
    EXPECT_NEAR(larger.boxExcessPercent, percent, 0.01 * percent);
    const SimplificationError smaller = meter.measure(scaled(sphere, 0.99));
    EXPECT_NEAR(smaller.meanPercent, percent, 0.01 * percent);
    EXPECT_EQ(smaller.boxExcessPercent, 0.0);
}

TEST(SimplificationMeter, LooksFromBothSides)
{
    const Mesh plane = testsupport::grid(10, 1);
    Mesh half = plane;
    half.faces.resize(10); // x from 0 to 5
    const double percent = 100.0 / std::sqrt(101.0);
    for (const SimplificationError& error :
         {SimplificationMeter(plane).measure(half), SimplificationMeter(half).measure(plane)})
        EXPECT_GT(error.maxPercent, 4.99 * percent) << "the far corners are 5 away from the half";
    EXPECT_EQ(SimplificationMeter(plane).measure(half).boxExcessPercent, 0.0);
    EXPECT_GT(SimplificationMeter(half).measure(plane).boxExcessPercent, 90.0);
}

TEST(SimplificationMeter, TakesTheMeanOverBothSidesTogether)
{
    const Mesh plane = testsupport::grid(10, 1);
    Mesh half = plane;
    half.faces.resize(10);
    // Half of the plane's points are 0 to 5 away, no point of the half is: a quarter of all, 2.5 away on
    // average.
    const double expected = 100.0 * 0.25 * 2.5 / std::sqrt(101.0);
    EXPECT_NEAR(SimplificationMeter(plane).measure(half).meanPercent, expected, 0.01 * expected);
}

TEST(SimplificationMeter, FindsTheTipOfASpikeThatNoSampleByAreaHits)
{
    const Mesh plane = testsupport::grid(100, 100);
    Mesh spiked = plane;
    spiked.positions[5000].z = 3.0;
    const SimplificationError error = SimplificationMeter(plane, 10).measure(spiked);
    EXPECT_NEAR(error.maxPercent, 3.0 / std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(error.boxExcessPercent, 3.0 / std::sqrt(2.0), 1e-9);
}

TEST(SimplificationMeter, LeavesOutVerticesThatNoFaceUses)
{
    const Mesh plane = testsupport::grid(2, 2);
    const SimplificationMeter meter(plane);
    Mesh level = plane;
    level.positions.emplace_back(0.0, 0.0, 7.0);
    EXPECT_EQ(meter.measure(level).boxExcessPercent, 0.0);
    level.wedgePositions[0] = static_cast<std::uint32_t>(plane.positions.size()); // the mutation
    EXPECT_GT(meter.measure(level).boxExcessPercent, 100.0);
}

TEST(SimplificationMeter, SaysThatAnEmptyLevelIsInfinitelyFarAway)
{
    const Mesh plane = testsupport::grid(2, 2);
    Mesh empty = plane;
    empty.faces.clear();
    const SimplificationError error = SimplificationMeter(plane).measure(empty);
    EXPECT_EQ(error.meanPercent, std::numeric_limits<double>::infinity());
    EXPECT_EQ(error.maxPercent, std::numeric_limits<double>::infinity());
    EXPECT_EQ(error.boxExcessPercent, 0.0);
}

TEST(SurfaceChange, IsWhatEveryTriangleLookedAtWouldSay)
{
    testsupport::Random random(5);
    const auto some = [&] { return asMesh(testsupport::soup(random, 60, 40)); };
    for (int round = 0; round < 20; ++round)
    {
        const Mesh meshes[] = {some(), some()};
        const MeasuredSurface surfaces[] = {MeasuredSurface(meshes[0], 500), MeasuredSurface(meshes[1], 500)};
        double sum = 0.0, largest = 0.0;
        for (int side = 0; side < 2; ++side)
        {
            const auto distance = [&](const glm::dvec3& place)
            {
                double least = std::numeric_limits<double>::infinity();
                for (const Triangle& t : surfaces[1 - side].triangles())
                {
                    const auto& p = meshes[1 - side].positions;
                    least =
                        std::min(least, glm::length(place - nearestPoint(place, p[t[0]], p[t[1]], p[t[2]])));
                }
                return least;
            };
            for (const SurfacePoint& point : surfaces[side].spreadPoints())
                sum += distance(point.position), largest = std::max(largest, distance(point.position));
            for (const glm::dvec3& point : surfaces[side].fixedPoints())
                largest = std::max(largest, distance(point));
        }
        const SurfaceChange change = surfaceChange(surfaces[0], surfaces[1]);
        EXPECT_NEAR(change.mean, sum / 1000.0, 1e-12);
        EXPECT_NEAR(change.largest, largest, 1e-12);
    }
}

TEST(MeasuredSurface, SpreadsPointsByArea)
{
    Mesh plane = testsupport::grid(2, 1);
    for (const std::uint32_t p : {2u, 5u})
        plane.positions[p].x = 4.0; // the second square is three times as large
    const MeasuredSurface surface(plane, 40000);
    std::size_t inSecond = 0;
    for (const SurfacePoint& point : surface.spreadPoints())
    {
        const Triangle& t = surface.triangles()[point.triangle];
        const glm::dvec3 &a = plane.positions[t[0]], &b = plane.positions[t[1]], &c = plane.positions[t[2]];
        ASSERT_LT(glm::length(a + point.second * (b - a) + point.third * (c - a) - point.position), 1e-12);
        inSecond += point.position.x > 1.0;
    }
    EXPECT_NEAR(static_cast<double>(inSecond), 30000.0, 400.0);
}

TEST(CountMissingMaterials, CountsThoseWhoseFacesAreAllGone)
{
    Mesh mesh = testsupport::grid(3, 1);
    mesh.materials = {{.name = "a"}, {.name = "b"}, {.name = "never used"}};
    mesh.faces[4].material = 1;
    Mesh level = mesh;
    EXPECT_EQ(countMissingMaterials(mesh, level), 0u);
    level.faces.erase(level.faces.begin() + 4);
    EXPECT_EQ(countMissingMaterials(mesh, level), 1u);
    level.faces.clear();
    EXPECT_EQ(countMissingMaterials(mesh, level), 2u);
}

} // namespace
