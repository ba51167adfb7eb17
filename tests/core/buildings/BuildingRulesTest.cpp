// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/BuildingRules.h"

#include <string>

#include <gtest/gtest.h>

#include "scenery/buildings/TagColour.h"

namespace
{

using namespace scenery;

std::vector<std::vector<glm::dvec2>> rectangle(double lengthM, double widthM)
{
    return {{{0, 0}, {lengthM, 0}, {lengthM, widthM}, {0, widthM}}};
}

TEST(BuildingRules, TagsAreStrongerThanRules)
{
    const auto tower = buildingOf(rectangle(20, 12),
                                  {{"building", "yes"},
                                   {"height", "30 m"},
                                   {"building:levels", "8"},
                                   {"roof:shape", "hipped"},
                                   {"roof:height", "4"},
                                   {"building:colour", "#336699"},
                                   {"roof:colour", "red"}},
                                  1);
    ASSERT_TRUE(tower);
    EXPECT_DOUBLE_EQ(tower->eavesM, 26.0);
    EXPECT_DOUBLE_EQ(tower->roofM, 4.0);
    EXPECT_EQ(tower->storeys, 8);
    EXPECT_EQ(tower->roof, RoofForm::hipped);
    EXPECT_NEAR(tower->wallTint.b, 0.6F, 1e-3);
    EXPECT_EQ(colourOfTag("red"), tower->roofTint);
}

TEST(BuildingRules, ARoofStandsOnPosts)
{
    const auto made = [](const BuildingTags& tags) { return *buildingOf(rectangle(20, 12), tags, 1); };
    for (const char* kind : {"roof", "carport"})
    {
        const Building roof = made({{"building", kind}, {"height", "5"}});
        EXPECT_TRUE(roof.isOnPosts) << kind;
        EXPECT_DOUBLE_EQ(roof.eavesM, 5.0) << kind;
        EXPECT_DOUBLE_EQ(roof.liftedM, 4.7) << kind;
        EXPECT_EQ(roof.openings, Openings::none) << kind;
    }
    EXPECT_DOUBLE_EQ(made({{"building", "roof"}, {"height", "5"}, {"min_height", "4"}}).liftedM, 4.0);
    const Building gabled =
        made({{"building", "roof"}, {"height", "5"}, {"roof:shape", "gabled"}, {"roof:height", "2"}});
    EXPECT_DOUBLE_EQ(gabled.liftedM, 2.7) << "below the eaves";
    const Building house = made({{"building", "house"}, {"height", "5"}});
    EXPECT_FALSE(house.isOnPosts) << "the control";
    EXPECT_EQ(house.liftedM, 0.0);
}

/// streets-gl 18, OSM2World 204: a guessed roof reached below where the part begins.
TEST(BuildingRules, TheRoofOfAPartBeginsAboveThePart)
{
    const auto made = [](const char* part, const char* low, const char* shape)
    {
        return *buildingOf(rectangle(20, 20),
                           {{"building", "yes"},
                            {"building:part", part},
                            {"height", "8.7"},
                            {"min_height", low},
                            {"roof:shape", shape}},
                           1);
    };
    for (const char* shape : {"gabled", "hipped", "pyramidal", "dome", "skillion"})
        for (const char* part : {"yes", "roof"})
            for (const char* low : {"5.7", "8", "3"})
            {
                const Building building = made(part, low, shape);
                EXPECT_DOUBLE_EQ(building.liftedM, std::stod(low)) << shape;
                EXPECT_GT(building.eavesM, building.liftedM) << shape;
                EXPECT_NEAR(building.eavesM + building.roofM, 8.7, 1e-9) << shape;
            }
    EXPECT_NEAR(made("roof", "3", "pyramidal").roofM, 5.65, 1e-9) << "nothing but a roof";
    EXPECT_LT(made("yes", "3", "pyramidal").roofM, 5.3) << "the control";
    EXPECT_EQ(made("yes", "9", "gabled").liftedM, 0.0) << "above its top";
}

TEST(BuildingRules, WithoutTagsTheSameIdGivesTheSameHouse)
{
    const BuildingTags tags{{"building", "house"}};
    const auto a = buildingOf(rectangle(11, 9), tags, 5), b = buildingOf(rectangle(11, 9), tags, 5);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->eavesM, b->eavesM);
    EXPECT_EQ(a->wallTint, b->wallTint);
    int gabled = 0, differing = 0;
    for (std::uint64_t id = 0; id < 1000; ++id)
    {
        const auto house = buildingOf(rectangle(11, 9), tags, id);
        gabled += house->roof == RoofForm::gabled;
        differing += house->wallTint != a->wallTint;
    }
    EXPECT_NEAR(gabled, 800, 50);
    EXPECT_GT(differing, 600);
}

TEST(BuildingRules, WhatHasNoAreaIsNoBuilding)
{
    EXPECT_FALSE(buildingOf({}, {}, 1));
    EXPECT_FALSE(buildingOf({{{0, 0}, {10, 0}}}, {}, 1));
    EXPECT_FALSE(buildingOf({{{0, 0}, {10, 0}, {20, 0}}}, {}, 1));
    EXPECT_FALSE(buildingOf(rectangle(900, 900), {}, 1));
    EXPECT_TRUE(buildingOf({{{0, 0}, {0, 9}, {9, 9}, {9, 0}}}, {}, 1)); // clockwise
}

TEST(BuildingRules, PointsAreTowersWhereTheirTagsSaySo)
{
    const auto mast = towerOf({5, 5}, {{"man_made", "mast"}, {"height", "45"}}, 1);
    ASSERT_TRUE(mast);
    EXPECT_DOUBLE_EQ(mast->eavesM + mast->roofM, 45.0);
    EXPECT_FALSE(towerOf({5, 5}, {{"man_made", "survey_point"}}, 1));
    EXPECT_FALSE(towerOf({5, 5}, {}, 1));
}

TEST(TagColour, ReadsNamesAndHexadecimalNumbers)
{
    EXPECT_EQ(colourOfTag("#fff"), glm::vec3(1.0F));
    EXPECT_EQ(colourOfTag("#000000"), glm::vec3(0.0F));
    EXPECT_TRUE(colourOfTag("beige"));
    for (const char* text : {"", "#", "#12", "#12345", "#gggggg", "brick;red", "#-12345"})
        EXPECT_FALSE(colourOfTag(text)) << text;
}

} // namespace
