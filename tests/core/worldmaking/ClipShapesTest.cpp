// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/ClipShapes.h"

#include <gtest/gtest.h>

namespace worldmaking
{
namespace
{

constexpr MapBounds kBounds{8.0, 46.0, 9.0, 47.0};
constexpr double kMarginDeg = 0.1;

LandShape shape(ShapeForm form, std::vector<glm::dvec2> path)
{
    return {7, form, {std::move(path)}, {{"natural", "wood"}}};
}

LandMap clipped(LandShape one)
{
    LandMap map;
    map.shapes.push_back(std::move(one));
    clipTo(kBounds, kMarginDeg, map);
    return map;
}

TEST(ClipShapes, WhatReachesOnlyALittleBeyondStaysAsItIs)
{
    const LandMap map = clipped(shape(ShapeForm::area, {{7.95, 46.5}, {8.5, 46.5}, {8.5, 46.6}}));
    ASSERT_EQ(map.shapes.size(), 1U);
    EXPECT_EQ(map.shapes[0].paths[0].front(), glm::dvec2(7.95, 46.5));
}

TEST(ClipShapes, AMistypedCornerDoesNotMakeAWoodOfAContinent)
{
    const LandMap map = clipped(shape(ShapeForm::area, {{8.5, 46.5}, {42.5, 46.5}, {8.5, 46.6}}));
    ASSERT_EQ(map.shapes.size(), 1U);
    EXPECT_EQ(map.shapes[0].id, 7);
    EXPECT_EQ(valueOf(map.shapes[0].tags, "natural"), "wood");
    for (const glm::dvec2& place : map.shapes[0].paths[0])
        EXPECT_LE(place.x, 9.1 + 1e-9);
}

TEST(ClipShapes, ALineThatLeavesAndComesBackFallsIntoTwo)
{
    const LandMap map =
        clipped(shape(ShapeForm::line, {{8.5, 46.5}, {12.0, 46.5}, {12.0, 46.6}, {8.5, 46.6}}));
    ASSERT_EQ(map.shapes.size(), 2U);
    EXPECT_NEAR(map.shapes[0].paths[0].back().x, 9.1, 1e-9);
    EXPECT_NEAR(map.shapes[1].paths[0].front().x, 9.1, 1e-9);
}

TEST(ClipShapes, AHoleStaysAHole)
{
    LandShape lake = shape(ShapeForm::area, {{8.2, 46.2}, {20.0, 46.2}, {20.0, 46.8}, {8.2, 46.8}});
    lake.paths.push_back({{8.4, 46.4}, {8.6, 46.4}, {8.6, 46.6}, {8.4, 46.6}});
    const LandMap map = clipped(lake);
    ASSERT_EQ(map.shapes.size(), 1U);
    ASSERT_EQ(map.shapes[0].paths.size(), 2U);
    EXPECT_EQ(map.shapes[0].paths[1].size(), 4U);
}

TEST(ClipShapes, AnOutlineThatCrossesItselfIsMendedAndCut)
{
    const LandMap map =
        clipped(shape(ShapeForm::area, {{8.2, 46.2}, {20.0, 46.8}, {20.0, 46.2}, {8.2, 46.8}}));
    ASSERT_GE(map.shapes.size(), 1U);
    for (const LandShape& piece : map.shapes)
        for (const glm::dvec2& place : piece.paths[0])
            EXPECT_LE(place.x, 9.1 + 1e-9);
}

TEST(ClipShapes, WhatLiesBeyondGoesAndIsCounted)
{
    LandMap map;
    map.shapes = {shape(ShapeForm::area, {{20.0, 46.5}, {21.0, 46.5}, {21.0, 47.0}}),
                  shape(ShapeForm::point, {{0.0, 0.0}}), shape(ShapeForm::point, {{8.5, 46.5}})};
    EXPECT_EQ(clipTo(kBounds, kMarginDeg, map), 2U);
    ASSERT_EQ(map.shapes.size(), 1U);
    EXPECT_EQ(map.shapes[0].form, ShapeForm::point);
}

} // namespace
} // namespace worldmaking
