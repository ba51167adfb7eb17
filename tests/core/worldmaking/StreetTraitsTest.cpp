// SPDX-License-Identifier: Apache-2.0
// What tags say about a street. Expected values are those of the OpenStreetMap wiki and of the table of
// classes.
#include "worldmaking/streets/StreetTraits.h"

#include <gtest/gtest.h>

namespace
{

using worldmaking::StreetPlace;
using worldmaking::Tags;
using worldmaking::traitsOf;

TEST(StreetTraits, LanesFollowTagsAndClass)
{
    struct Case
    {
        Tags tags;
        int forward, backward;
    };
    const std::vector<Case> cases = {
        {{{"highway", "residential"}}, 1, 1},
        {{{"highway", "residential"}, {"oneway", "yes"}}, 1, 0},
        {{{"highway", "residential"}, {"oneway", "-1"}}, 0, 1},
        {{{"highway", "motorway"}}, 2, 0},
        {{{"highway", "motorway"}, {"oneway", "no"}, {"lanes", "2"}}, 1, 1},
        {{{"highway", "motorway_link"}}, 1, 1},
        {{{"highway", "primary"}, {"lanes", "3"}}, 2, 1},
        {{{"highway", "primary"}, {"lanes", "5"}, {"lanes:backward", "3"}}, 3, 3},
        {{{"highway", "primary"}, {"lanes", "3"}, {"oneway", "yes"}}, 3, 0},
        {{{"highway", "primary"}, {"lanes", "many"}}, 1, 1},
        {{{"highway", "primary"}, {"lanes", "-4"}}, 1, 1},
        {{{"highway", "tertiary"}, {"junction", "roundabout"}}, 1, 0},
    };
    for (const Case& entry : cases)
    {
        const auto traits = traitsOf(entry.tags);
        ASSERT_TRUE(traits);
        EXPECT_EQ(traits->forwardLanes, entry.forward) << entry.tags.rbegin()->second;
        EXPECT_EQ(traits->backwardLanes, entry.backward) << entry.tags.rbegin()->second;
    }
}

TEST(StreetTraits, WhatCarsCannotUseIsNone)
{
    EXPECT_FALSE(traitsOf({{"highway", "footway"}}));
    EXPECT_FALSE(traitsOf({{"highway", "track"}}));
    EXPECT_FALSE(traitsOf({{"highway", "proposed"}}));
    EXPECT_FALSE(traitsOf({{"highway", "service"}, {"access", "no"}}));
    EXPECT_FALSE(traitsOf({{"highway", "residential"}, {"motor_vehicle", "no"}}));
    EXPECT_TRUE(traitsOf({{"highway", "service"}, {"access", "no"}, {"motorcar", "yes"}}));
    EXPECT_FALSE(traitsOf({{"highway", "pedestrian"}}));
}

TEST(StreetTraits, PlaceSpeedAndReversal)
{
    const auto traits = traitsOf({{"highway", "secondary"},
                                  {"bridge", "viaduct"},
                                  {"maxspeed", "30 mph"},
                                  {"oneway", "yes"},
                                  {"sidewalk", "right"}});
    ASSERT_TRUE(traits);
    EXPECT_EQ(traits->place, StreetPlace::bridge);
    EXPECT_NEAR(traits->speedKmh, 48.28, 0.01);
    EXPECT_TRUE(traits->hasRightSidewalk);
    EXPECT_FALSE(traits->hasLeftSidewalk);
    const auto back = traits->reversed();
    EXPECT_EQ(back.forwardLanes, 0);
    EXPECT_EQ(back.backwardLanes, 1);
    EXPECT_TRUE(back.hasLeftSidewalk);
    EXPECT_EQ(traitsOf({{"highway", "service"}, {"tunnel", "building_passage"}})->place, StreetPlace::ground);
    EXPECT_EQ(traitsOf({{"highway", "service"}, {"tunnel", "yes"}})->place, StreetPlace::tunnel);
}

} // namespace
