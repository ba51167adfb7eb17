// SPDX-License-Identifier: Apache-2.0
// Tests queries of the drawn surface: of every method, against the samples, and of ROAM against the descent
// of its tree.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/method/PrepareTerrain.h>
#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/DrawnSurface.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/roam/UpperSurface.h>

#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"

namespace
{

using namespace osgTerrainROAM::core;

constexpr int kSide = 97;
constexpr double kRoundingM = 1e-3;

std::shared_ptr<const RoamTile> queriedTile()
{
    static const auto tile = testsupport::planarTile(testsupport::hills(kSide, kSide, 30.0));
    return tile;
}

std::unique_ptr<TerrainMesh> refinedMesh(Method method, bool morphing = false)
{
    auto mesh = (*prepareTerrain(queriedTile(), {.method = method}))->newMesh();
    if (morphing) mesh->setMorphing(true);
    for (int frame = 0; frame < (morphing ? 12 : 1); ++frame) // vertices move from the second one on
        mesh->refine(measurement::BenchmarkFlight{}.view(queriedTile()->tile, frame),
                     {.errorTolerancePx = 24.0});
    return mesh;
}

TEST(DrawnSurface, TellsTheHeightAtEverySampleAndBoundsItsErrorByEveryMethod)
{
    const PlacedTile& tile = queriedTile()->tile;
    for (const MethodTraits& traits : kMethods)
    {
        const DrawnMesh drawn = refinedMesh(traits.method)->drawn();
        const DrawnSurface surface(tile, drawn);
        const UpperSurface upper(tile, drawn);
        double largestM = 0.0;
        for (int row = 0; row < kSide; row += 3)
            for (int column = 0; column < kSide; column += 2)
            {
                const glm::dvec3 sample = tile.position(column, row);
                const auto ground = surface.at(sample.x, sample.y);
                ASSERT_TRUE(ground) << traits.name << ' ' << column << ' ' << row;
                ASSERT_NEAR(ground->position.z, upper.point(column, row).z, kRoundingM) << traits.name;
                ASSERT_GE(ground->boundM + kRoundingM, std::abs(ground->position.z - sample.z))
                    << traits.name << ' ' << column << ' ' << row;
                EXPECT_GT(ground->normal.z, 0.0);
                largestM = std::max(largestM, ground->boundM);
            }
        EXPECT_GT(largestM, 0.1) << traits.name << ": nothing is simplified";
        const double beyondM = tile.position(kSide - 1, 0).x + 1.0;
        EXPECT_FALSE(surface.at(beyondM, 0.0) || surface.at(-1.0, 0.0) || surface.at(0.0, NAN));
    }
}

TEST(DrawnSurface, AgreesWithTheDescentOfRoamsTree)
{
    const auto mesh = refinedMesh(Method::roam);
    const auto& roam = dynamic_cast<const RoamMesh&>(*mesh);
    const DrawnSurface surface(queriedTile()->tile, mesh->drawn());
    testsupport::Random random(5);
    const double sideM = 30.0 * (kSide - 1);
    for (int i = 0; i < 500; ++i)
    {
        const double east = sideM * random.unit(), north = sideM * random.unit();
        const auto here = surface.at(east, north);
        const auto there = drawnGroundAt(roam.tree(), east, north);
        ASSERT_TRUE(here && there);
        EXPECT_NEAR(here->position.z, there->position.z, kRoundingM);
        EXPECT_LE(here->boundM, there->boundM + kRoundingM) << "measured is not more than proved";
    }
}

TEST(DrawnSurface, FollowsVerticesThatMoveSideways)
{
    const PlacedTile& tile = queriedTile()->tile;
    const DrawnSurface surface(tile, refinedMesh(Method::vdpm, true)->drawn());
    for (int row = 1; row < kSide - 1; row += 5)
        for (int column = 1; column < kSide - 1; column += 5)
        {
            const glm::dvec3 sample = tile.position(column, row);
            const auto ground = surface.at(sample.x, sample.y);
            ASSERT_TRUE(ground) << column << ' ' << row;
            ASSERT_GE(ground->boundM + 0.05, std::abs(ground->position.z - sample.z));
        }
}

TEST(DrawnSurface, AVertexThatIsOffIsInTheBound) // the control
{
    DrawnMesh drawn = refinedMesh(Method::vipmOverlapping)->drawn();
    const PlacedTile& tile = queriedTile()->tile;
    const glm::dvec3 sample = tile.position(40, 41);
    const auto before = DrawnSurface(tile, drawn).at(sample.x, sample.y);
    ASSERT_TRUE(before);
    for (const std::uint32_t v : before->triangle.vertices)
        drawn.vertices[v].position.z += static_cast<int>(300.0 / drawn.stepM);
    const auto after = DrawnSurface(tile, drawn).at(sample.x, sample.y);
    ASSERT_TRUE(after);
    EXPECT_NEAR(after->position.z, before->position.z + 300.0, 1.0);
    EXPECT_GT(after->boundM, 250.0);
}

} // namespace
