// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include <osgPMObjects/core/simplify/SupportVertices.h>

#include "ClosedMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using namespace testsupport;

/// Eight vertices in a box from 0 to 4: five in the cell from 0 to 2, whose centre is (1, 1, 1), one in the
/// cell from 2 to 4, and two in others.
Mesh byHand()
{
    return meshOf({{0, 0, 0},       // squared distance from the centre 3: the farthest
                   {1, 1, 0},       // 1
                   {1.5, 1.5, 1},   // 0.5: the nearest
                   {0.5, 1, 1.75},  // 0.8125
                   {1.9, 1.9, 1.9}, // 2.43
                   {4, 4, 4},       // alone
                   {4, 0, 0},       // alone
                   {0, 4, 0}},      // alone
                  {{0, 1, 2}, {2, 3, 4}, {4, 5, 6}, {5, 6, 7}});
}

TEST(SupportVertices, TheFarthestAndTheNearestOfEachCellByHand)
{
    const Mesh mesh = byHand();
    const OctreeDivisions divisions = OctreeDivisions::ofDepth(1);
    using Marks = std::vector<bool>;
    EXPECT_EQ(supportVertices(mesh, divisions, SupportRule::none), Marks(8, false));
    EXPECT_EQ(supportVertices(mesh, divisions, SupportRule::farthest), Marks({1, 0, 0, 0, 0, 1, 1, 1}));
    EXPECT_EQ(supportVertices(mesh, divisions, SupportRule::farthestAndNearest),
              Marks({1, 0, 1, 0, 0, 1, 1, 1}));
}

TEST(SupportVertices, AMovedCentreWouldBeSeen)
{
    // By the formula of the source all centres of two divisions are (1, 1, 1): in the upper cell, (3.9, 3.9,
    // 3.9) would be the nearest.
    const Mesh mesh = meshOf({{0, 0, 0}, {4, 4, 4}, {3.9, 3.9, 3.9}, {2.5, 2.5, 3}}, {{0, 1, 2}, {1, 2, 3}});
    const auto isSupport =
        supportVertices(mesh, OctreeDivisions::ofDepth(1), SupportRule::farthestAndNearest);
    EXPECT_EQ(isSupport, std::vector<bool>({1, 1, 0, 1}));
}

TEST(SupportVertices, CentresAreThoseOfTheCells)
{
    const Extent box{{0, 0, -1}, {4, 8, 1}};
    const OctreeDivisions divisions{{4, 2, 1}};
    EXPECT_EQ(centreOf({0, 0, 0}, box, divisions), glm::dvec3(0.5, 2, 0));
    EXPECT_EQ(centreOf({3, 1, 0}, box, divisions), glm::dvec3(3.5, 6, 0));
    for (std::uint32_t x = 0; x < 4; ++x)
        for (std::uint32_t y = 0; y < 2; ++y)
        {
            const std::array<std::uint32_t, 3> cell = {x, y, 0};
            EXPECT_EQ(cellOf(centreOf(cell, box, divisions), box, divisions), cell);
        }
    EXPECT_EQ(cellOf({1, 4, 1}, box, divisions), (std::array<std::uint32_t, 3>{1, 1, 0}))
        << "on a border: the upper";
    EXPECT_EQ(cellOf({4, 8, 1}, box, divisions), (std::array<std::uint32_t, 3>{3, 1, 0}))
        << "on the box's: the last";
}

TEST(SupportVertices, EquallyFarOnesAreAllMarked)
{
    const auto isSupport = supportVertices(cube(), OctreeDivisions::ofDepth(0), SupportRule::farthest);
    EXPECT_EQ(std::count(isSupport.begin(), isSupport.end(), true), 8);
}

TEST(SupportVertices, DivisionsArePowersOfTwo)
{
    EXPECT_TRUE(OctreeDivisions::ofDepth(0).isValid());
    EXPECT_EQ(OctreeDivisions::ofDepth(3).counts, (std::array<std::uint32_t, 3>{8, 8, 8}));
    EXPECT_TRUE((OctreeDivisions{{1, 4, 1024}}).isValid());
    EXPECT_FALSE((OctreeDivisions{{3, 4, 4}}).isValid());
    EXPECT_FALSE((OctreeDivisions{{0, 4, 4}}).isValid());
    EXPECT_FALSE((OctreeDivisions{{2048, 4, 4}}).isValid());
}

TEST(SupportVertices, AFlatMeshHasOneLayerOfCells)
{
    const Mesh sheet = grid(8, 8);
    const auto isSupport =
        supportVertices(sheet, OctreeDivisions::ofDepth(2), SupportRule::farthestAndNearest);
    EXPECT_GE(std::count(isSupport.begin(), isSupport.end(), true), 16 * 2);
}

TEST(SupportVertices, PositionsWithoutFacesAreNone)
{
    Mesh mesh = byHand();
    mesh.positions.emplace_back(-100, 0, 0);
    mesh.wedgePositions.push_back(8);
    const auto isSupport =
        supportVertices(mesh, OctreeDivisions::ofDepth(1), SupportRule::farthestAndNearest);
    EXPECT_EQ(isSupport, std::vector<bool>({1, 0, 1, 0, 0, 1, 1, 1, 0}));
}

} // namespace
