// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"
#include "measurement/SplitFully.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::Random;

std::shared_ptr<const RoamTile> tileOf(bool curved)
{
    HeightField field = testsupport::hills(50, 65);
    return std::make_shared<const RoamTile>(curved ? PlacedTile(testsupport::onTheEarth(std::move(field)))
                                                   : PlacedTile(std::move(field), Placement::planar));
}

/// A place over the data, a little inside its edge.
glm::dvec2 randomPlace(const PlacedTile& tile, Random& random)
{
    const double column = 0.1 + random.unit() * (tile.grid().dataColumns() - 1.2);
    const double row = 0.1 + random.unit() * (tile.grid().dataRows() - 1.2);
    return glm::dvec2(tile.frame().positionAt(column, row, 400.0));
}

class DrawnGroundTest : public testing::TestWithParam<bool>
{
};

TEST_P(DrawnGroundTest, IsTheTrueOneAtFullResolution)
{
    const auto tile = tileOf(GetParam());
    DiamondTree tree(tile);
    measurement::splitFully(tree);
    Random random(2);
    for (int i = 0; i < 2000; ++i)
    {
        const glm::dvec2 place = randomPlace(tile->tile, random);
        const auto drawn = drawnGroundAt(tree, place.x, place.y);
        const auto truth = groundAt(tile->tile, place.x, place.y);
        ASSERT_TRUE(drawn && truth) << place.x << ' ' << place.y;
        EXPECT_NEAR(drawn->position.z, truth->position.z, 1e-6);
        EXPECT_GT(glm::dot(drawn->normal, truth->normal), 1.0 - 1e-6);
        EXPECT_EQ(drawn->boundM, 0.0);
    }
}

TEST_P(DrawnGroundTest, KeepsTheBoundToTheTrueOne)
{
    const auto tile = tileOf(GetParam());
    RoamMesh mesh(tile);
    Random random(3);
    double largest = 0.0, largestShare = 0.0;
    for (const double errorM : {80.0, 30.0, 8.0, 1.0})
    {
        mesh.refine(errorM);
        for (int i = 0; i < 500; ++i)
        {
            const glm::dvec2 place = randomPlace(tile->tile, random);
            const auto drawn = drawnGroundAt(mesh.tree(), place.x, place.y);
            const auto truth = groundAt(tile->tile, place.x, place.y);
            ASSERT_TRUE(drawn && truth);
            const double off = GetParam()
                                   ? std::fabs(glm::dot(truth->position - drawn->position, drawn->normal))
                                   : std::fabs(truth->position.z - drawn->position.z);
            EXPECT_LE(off, drawn->boundM + 1e-3);
            EXPECT_LE(drawn->boundM, errorM) << "a leaf that should have been split";
            EXPECT_TRUE(mesh.tree().isLeaf(drawn->leaf));
            largest = std::max(largest, off);
            if (drawn->boundM > 0.0) largestShare = std::max(largestShare, off / drawn->boundM);
        }
    }
    EXPECT_GT(largest, 5.0) << "nothing was simplified: nothing was checked";
    EXPECT_GT(largestShare, 0.5) << "a bound that nothing comes near to could be anything";
}

TEST_P(DrawnGroundTest, IsTheSameForManyPlacesAtOnce)
{
    const auto tile = tileOf(GetParam());
    RoamMesh mesh(tile);
    mesh.refine(8.0);
    Random random(6);
    std::vector<glm::dvec2> places;
    for (int i = 0; i < 101; ++i)
        places.push_back(randomPlace(tile->tile, random));
    places[40] = {-1e7, 0.0};
    places[41] = {std::nan(""), 0.0};
    std::vector<std::optional<osgTerrainROAM::core::DrawnGround>> grounds(places.size());
    drawnGroundAt(mesh.tree(), places, grounds);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const auto alone = drawnGroundAt(mesh.tree(), places[i].x, places[i].y);
        ASSERT_EQ(alone.has_value(), grounds[i].has_value()) << i;
        if (!alone) continue;
        EXPECT_EQ(alone->position, grounds[i]->position);
        EXPECT_EQ(alone->boundM, grounds[i]->boundM);
        EXPECT_EQ(alone->leaf, grounds[i]->leaf);
    }
    EXPECT_FALSE(grounds[40] || grounds[41]);
}

TEST_P(DrawnGroundTest, IsNowhereBeyondTheData)
{
    const auto tile = tileOf(GetParam());
    RoamMesh mesh(tile);
    mesh.refine(10.0);
    const PlacedTile& placed = tile->tile;
    for (const glm::dvec2 grid : {glm::dvec2(-2.0, 20.0), glm::dvec2(51.0, 20.0), glm::dvec2(60.0, 60.0),
                                  glm::dvec2(20.0, 66.0), glm::dvec2(20.0, -2.0), glm::dvec2(1e6, 1e6)})
    {
        const glm::dvec3 place = placed.frame().positionAt(grid.x, grid.y, 400.0);
        EXPECT_FALSE(drawnGroundAt(mesh.tree(), place.x, place.y)) << grid.x << ' ' << grid.y;
    }
    EXPECT_FALSE(drawnGroundAt(mesh.tree(), std::nan(""), 0.0));
}

INSTANTIATE_TEST_SUITE_P(Placements, DrawnGroundTest, testing::Bool(),
                         [](const auto& given) { return given.param ? "curved" : "planar"; });

} // namespace
