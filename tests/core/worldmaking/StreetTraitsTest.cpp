// SPDX-License-Identifier: Apache-2.0
// What tags say about a street. Expected values are those of the OpenStreetMap wiki and of the table of
// classes.
#include "worldmaking/streets/StreetTraits.h"

#include <bit>
#include <utility>

#include <gtest/gtest.h>

#include "worldmaking/map/SpeedTags.h"
#include "worldmaking/streets/LaneLayout.h"

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
        {{{"highway", "primary"}, {"lanes", "5"}, {"lanes:backward", "3"}}, 2, 3},
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

/// Lanes forward, backward, in the middle for both, and those of both directions that are for buses.
struct LaneCase
{
    Tags tags;
    int forward, backward, shared, forwardBus, backwardBus;
};

void expectLanes(const std::vector<LaneCase>& cases)
{
    for (const LaneCase& entry : cases)
    {
        std::string name;
        for (const auto& [key, value] : entry.tags)
            name += key + "=" + value + " ";
        const auto traits = traitsOf(entry.tags);
        ASSERT_TRUE(traits) << name;
        EXPECT_EQ(traits->forwardLanes, entry.forward) << name;
        EXPECT_EQ(traits->backwardLanes, entry.backward) << name;
        EXPECT_EQ(traits->sharedLanes, entry.shared) << name;
        EXPECT_EQ(std::popcount(traits->forwardBusLanes), entry.forwardBus) << name;
        EXPECT_EQ(std::popcount(traits->backwardBusLanes), entry.backwardBus) << name;
    }
}

TEST(StreetTraits, ASingleTrackHasOneLaneForBothDirections)
{
    expectLanes({
        {{{"highway", "residential"}, {"lanes", "1"}}, 0, 0, 1, 0, 0},
        {{{"highway", "tertiary"}, {"lanes", "1.5"}}, 0, 0, 1, 0, 0},
        {{{"highway", "unclassified"}, {"width", "3"}}, 0, 0, 1, 0, 0},
        {{{"highway", "unclassified"}, {"width", "3"}, {"lanes", "2"}}, 1, 1, 0, 0, 0},
        {{{"highway", "unclassified"}, {"width", "10 ft"}}, 0, 0, 1, 0, 0},
        {{{"highway", "residential"}, {"lanes", "1"}, {"oneway", "yes"}}, 1, 0, 0, 0, 0},
        {{{"highway", "residential"}, {"lanes", "1"}, {"lanes:forward", "1"}, {"lanes:backward", "1"}},
         1,
         1,
         0,
         0,
         0},
        {{{"highway", "residential"}, {"oneway", "reversible"}}, 0, 0, 1, 0, 0},
        {{{"highway", "residential"}, {"oneway", "alternating"}, {"lanes", "1"}}, 0, 0, 1, 0, 0},
    });
    const auto single = traitsOf({{"highway", "residential"}, {"lanes", "1"}});
    EXPECT_EQ(single->laneWidthM, 3.5);
    EXPECT_TRUE(single->isSingleTrack());
    EXPECT_EQ(traitsOf({{"highway", "residential"}, {"width", "3.2 m"}})->laneWidthM, 3.2);
}

TEST(StreetTraits, BusesMayGoAgainstAOneWayStreet)
{
    expectLanes({
        {{{"highway", "secondary"},
          {"oneway", "yes"},
          {"oneway:bus", "no"},
          {"lanes", "3"},
          {"lanes:forward", "2"},
          {"lanes:backward", "1"}},
         2,
         1,
         0,
         0,
         1},
        {{{"highway", "secondary"}, {"oneway", "yes"}, {"oneway:psv", "no"}, {"lanes", "3"}}, 2, 1, 0, 0, 1},
        {{{"highway", "secondary"}, {"oneway", "yes"}, {"oneway:bus", "no"}, {"lanes", "1"}}, 1, 0, 0, 0, 0},
        {{{"highway", "secondary"}, {"oneway", "yes"}, {"busway", "opposite_lane"}}, 1, 1, 0, 0, 1},
        {{{"highway", "secondary"}, {"oneway", "-1"}, {"busway:left", "opposite_lane"}, {"lanes", "2"}},
         1,
         1,
         0,
         1,
         0},
        {{{"highway", "secondary"}, {"oneway", "yes"}, {"lanes", "2"}, {"lanes:psv:backward", "1"}},
         1,
         1,
         0,
         0,
         1},
        {{{"highway", "secondary"}, {"oneway", "yes"}, {"cycleway", "opposite_lane"}}, 1, 0, 0, 0, 0},
        {{{"highway", "secondary"}, {"oneway", "yes"}, {"oneway:bicycle", "no"}, {"cycleway", "opposite"}},
         1,
         0,
         0,
         0,
         0},
        {{{"highway", "secondary"}, {"oneway", "yes"}, {"lanes:backward", "1"}}, 1, 0, 0, 0, 0},
        {{{"highway", "secondary"}, {"oneway", "yes"}, {"lanes", "3"}, {"lanes:psv", "1"}}, 3, 0, 0, 1, 0},
        {{{"highway", "secondary"}, {"oneway", "yes"}, {"oneway:motor_vehicle", "no"}}, 1, 1, 0, 0, 0},
        {{{"highway", "residential"}, {"oneway", "no"}, {"oneway:vehicle", "yes"}}, 1, 0, 0, 0, 0},
    });
}

TEST(StreetTraits, LanesForBusesLieWhereTheListHasThem)
{
    const auto forward = [](const std::string& list, const char* key = "bus:lanes")
    {
        return traitsOf({{"highway", "primary"}, {"oneway", "yes"}, {"lanes", "3"}, {key, list}})
            ->forwardBusLanes;
    };
    EXPECT_EQ(forward("yes|yes|designated"), 0b100U);
    EXPECT_EQ(forward("yes|designated|yes"), 0b010U);
    EXPECT_EQ(forward("designated||"), 0b001U);
    EXPECT_EQ(forward("designated|yes|official", "psv:lanes"), 0b101U);
    // A fourth entry is a lane for bicycles: which of the others is meant is not known.
    EXPECT_EQ(forward("yes|yes|designated|designated"), 0b100U);
    const auto both = traitsOf({{"highway", "primary"},
                                {"lanes", "5"},
                                {"lanes:forward", "3"},
                                {"bus:lanes:forward", "yes|designated|yes"},
                                {"bus:lanes:backward", "designated|yes"}});
    EXPECT_EQ(both->forwardBusLanes, 0b010U);
    EXPECT_EQ(both->backwardBusLanes, 0b001U);
    EXPECT_EQ(both->reversed().forwardBusLanes, 0b001U);
    EXPECT_FALSE(both->hasSameLanes(*traitsOf({{"highway", "primary"},
                                               {"lanes", "5"},
                                               {"lanes:forward", "3"},
                                               {"bus:lanes:forward", "yes|yes|designated"},
                                               {"bus:lanes:backward", "designated|yes"}})));
}

TEST(StreetTraits, LanesThatAreClosedToCarsAreForThoseThatMayUseThem)
{
    // Three lanes against the way of cars and with it; the inner one with rails (a report of a converter).
    expectLanes(
        {{{{"highway", "tertiary"},
           {"oneway", "yes"},
           {"oneway:bus", "no"},
           {"lanes", "3"},
           {"lanes:forward", "2"},
           {"lanes:backward", "1"},
           {"bus:lanes:backward", "yes"},
           {"vehicle:lanes:forward", "no|yes"}},
          2,
          1,
          0,
          1,
          1},
         {{{"highway", "tertiary"}, {"oneway", "yes"}, {"vehicle:lanes", "yes|yes|no"}}, 3, 0, 0, 1, 0},
         {{{"highway", "tertiary"}, {"lanes", "4"}, {"access:lanes:backward", "yes|no"}}, 2, 2, 0, 0, 1},
         {{{"highway", "tertiary"},
           {"lanes", "4"},
           {"access:lanes:forward", "no|yes"},
           {"motor_vehicle:lanes:forward", "yes|"}},
          2,
          2,
          0,
          0,
          0},
         // Lists count the lane for bicycles, `lanes` does not.
         {{{"highway", "tertiary"},
           {"oneway", "yes"},
           {"lanes", "2"},
           {"vehicle:lanes", "yes|no|no"},
           {"bus:lanes", "yes|designated|no"},
           {"bicycle:lanes", "no|no|designated"}},
          2,
          0,
          0,
          1,
          0},
         // A lane for bicycles against a one-way street is no lane for buses.
         {{{"highway", "tertiary"},
           {"oneway", "yes"},
           {"vehicle:lanes:backward", "no"},
           {"bicycle:lanes:backward", "designated"}},
          1,
          0,
          0,
          0,
          0}});
    const auto inner =
        traitsOf({{"highway", "tertiary"}, {"oneway", "yes"}, {"lanes", "2"}, {"vehicle:lanes", "no|yes"}});
    EXPECT_EQ(inner->forwardBusLanes, 0b01U) << "the left one";
}

TEST(StreetTraits, ALaneForBicyclesAtTheEdgeOfAListIsACycleLane)
{
    using worldmaking::CycleWay;
    const auto sides = [](Tags tags)
    {
        tags.emplace("highway", "tertiary");
        const auto traits = traitsOf(tags);
        return std::pair(traits->leftCycles, traits->rightCycles);
    };
    const std::pair none{CycleWay::none, CycleWay::none}, right{CycleWay::none, CycleWay::lane};
    EXPECT_EQ(sides({{"oneway", "yes"}, {"lanes", "1"}, {"bicycle:lanes", "|designated"}}), right);
    EXPECT_EQ(sides({{"lanes", "2"},
                     {"vehicle:lanes:forward", "yes|no"},
                     {"bicycle:lanes:forward", "|yes"},
                     {"lanes:forward", "1"}}),
              right);
    EXPECT_EQ(sides({{"oneway", "yes"}, {"lanes", "2"}, {"bicycle:lanes", "yes|designated|yes"}}), none)
        << "in the middle";
    EXPECT_EQ(sides({{"oneway", "yes"}, {"lanes", "2"}, {"bicycle:lanes", "yes|designated"}}), none)
        << "both are for cars";
    EXPECT_EQ(sides({{"oneway", "yes"}, {"bicycle:lanes", "|designated"}, {"vehicle:lanes", "|yes"}}), none)
        << "cars, too";
    EXPECT_EQ(sides({{"lanes:backward", "1"}, {"bicycle:lanes:backward", "|designated"}}),
              std::pair(CycleWay::lane, CycleWay::none));
    EXPECT_EQ(
        sides({{"oneway", "yes"}, {"bicycle:lanes", "|designated"}, {"cycleway:right", "track"}}).second,
        CycleWay::track);
}

TEST(StreetTraits, AStreetForBusesAloneIsNotClosed)
{
    expectLanes(
        {{{{"highway", "residential"}, {"access", "no"}, {"bus", "yes"}, {"psv", "yes"}, {"lanes", "2"}},
          1,
          1,
          0,
          1,
          1},
         {{{"highway", "service"}, {"motor_vehicle", "no"}, {"psv", "designated"}, {"oneway", "yes"}},
          1,
          0,
          0,
          1,
          0},
         {{{"highway", "residential"}, {"bus", "yes"}}, 1, 1, 0, 0, 0}});
    EXPECT_FALSE(traitsOf({{"highway", "residential"}, {"access", "no"}, {"bus", "no"}}));
    EXPECT_FALSE(traitsOf({{"highway", "residential"}, {"access", "no"}, {"bicycle", "yes"}}));
}

TEST(StreetTraits, ABuswayHasLanesForBusesAlone)
{
    expectLanes({{{{"highway", "busway"}}, 1, 1, 0, 1, 1},
                 {{{"highway", "busway"}, {"oneway", "yes"}, {"lanes", "2"}}, 2, 0, 0, 2, 0},
                 {{{"highway", "busway"}, {"access", "no"}, {"bus", "designated"}}, 1, 1, 0, 1, 1}});
    EXPECT_FALSE(traitsOf({{"highway", "busway"}, {"bus", "no"}}));
    const auto single = worldmaking::layoutOf(*traitsOf({{"highway", "busway"}, {"lanes", "1"}}));
    ASSERT_EQ(single.right.size(), 1u);
    EXPECT_TRUE(single.right[0].isForBuses) << "a single track, too";
    EXPECT_EQ(traitsOf({{"highway", "residential"}})->forwardBusLanes, 0U) << "the control";
}

TEST(StreetTraits, LanesOfADirectionAndOfTheMiddleAreRead)
{
    expectLanes({
        {{{"highway", "primary"}, {"lanes", "3"}, {"lanes:forward", "1"}, {"lanes:backward", "2"}},
         1,
         2,
         0,
         0,
         0},
        {{{"highway", "primary"}, {"lanes", "3"}, {"lanes:forward", "1"}}, 1, 2, 0, 0, 0},
        {{{"highway", "primary"},
          {"lanes", "3"},
          {"lanes:both_ways", "1"},
          {"lanes:forward", "1"},
          {"lanes:backward", "1"}},
         1,
         1,
         1,
         0,
         0},
        {{{"highway", "primary"}, {"lanes", "5"}, {"lanes:both_ways", "1"}}, 2, 2, 1, 0, 0},
        {{{"highway", "primary"}, {"lanes", "3"}, {"centre_turn_lane", "yes"}}, 1, 1, 1, 0, 0},
        {{{"highway", "primary"}, {"lanes", "4"}}, 2, 2, 0, 0, 0},
        {{{"highway", "primary"}, {"turn:lanes:forward", "left|through|right"}}, 3, 1, 0, 0, 0},
        {{{"highway", "primary"}, {"oneway", "yes"}, {"turn:lanes", "left|through|through;right"}},
         3,
         0,
         0,
         0,
         0},
        {{{"highway", "primary"}, {"oneway", "yes"}, {"turn:lanes", "left|right"}, {"lanes", "3"}},
         3,
         0,
         0,
         0,
         0},
        {{{"highway", "primary"}, {"oneway", "yes"}, {"turn:lanes", "|||||||||||||||||||||||||||"}},
         1,
         0,
         0,
         0,
         0},
        {{{"highway", "primary"}, {"lanes", "2;3"}}, 1, 1, 0, 0, 0},
        {{{"highway", "primary"}, {"lanes", "0"}}, 1, 1, 0, 0, 0},
        {{{"highway", "primary"}, {"lanes", "99"}}, 1, 1, 0, 0, 0},
        {{{"highway", "primary"}, {"lanes", "12"}}, 6, 6, 0, 0, 0},
        {{{"highway", "motorway_link"}, {"oneway", "no"}, {"lanes", "2"}}, 1, 1, 0, 0, 0},
        {{{"highway", "primary"}, {"oneway", "true"}}, 1, 0, 0, 0, 0},
        {{{"highway", "primary"}, {"oneway", "reverse"}, {"lanes", "2"}}, 0, 2, 0, 0, 0},
        {{{"highway", "primary"}, {"junction", "circular"}, {"lanes", "2"}}, 2, 0, 0, 0, 0},
    });
}

TEST(StreetTraits, WidthIsSharedByTheLanes)
{
    EXPECT_EQ(traitsOf({{"highway", "tertiary"}, {"lanes", "2"}, {"width", "9.5 m"}})->laneWidthM, 4.75);
    EXPECT_NEAR(traitsOf({{"highway", "tertiary"}, {"width", "20'"}})->laneWidthM, 3.048, 1e-9);
    EXPECT_EQ(traitsOf({{"highway", "tertiary"}, {"width:carriageway", "7"}, {"width", "11"}})->laneWidthM,
              3.5);
    EXPECT_EQ(traitsOf({{"highway", "tertiary"}, {"width", "wide"}})->laneWidthM, 3.0);
    worldmaking::TagCounts told;
    EXPECT_EQ(traitsOf({{"highway", "tertiary"}, {"width", "40"}}, &told)->laneWidthM, 3.0)
        << "no lane is so wide";
    EXPECT_EQ(told, (worldmaking::TagCounts{{"width=40", 1}}));
}

TEST(StreetTraits, WhatIsTakenForSomethingElseIsTold)
{
    worldmaking::TagCounts told;
    (void)traitsOf({{"highway", "primary"}, {"lanes", "2;3"}}, &told);
    (void)traitsOf({{"highway", "primary"}, {"lanes", "2;3"}}, &told);
    (void)traitsOf({{"highway", "primary"}, {"lanes", "1.5"}, {"oneway", "reversible"}}, &told);
    (void)traitsOf({{"highway", "primary"}, {"oneway", "yes"}, {"lanes", "2"}, {"maxspeed", "50"}}, &told);
    EXPECT_EQ(told, (worldmaking::TagCounts{{"lanes=2;3", 2}, {"lanes=1.5", 1}, {"oneway=reversible", 1}}));
}

TEST(StreetTraits, SpeedsHaveUnitsAndWords)
{
    using worldmaking::speedKmhOf;
    struct Case
    {
        const char* text;
        double kmh;
    };
    for (const Case& entry : std::initializer_list<Case>{{"50", 50},
                                                         {"30 mph", 48.28032},
                                                         {"85 mph", 136.79424},
                                                         {"DE:urban", 50},
                                                         {"de:urban", 50},
                                                         {"DE:rural", 100},
                                                         {"DE:motorway", 130},
                                                         {"DE:living_street", 5},
                                                         {"DE:zone:30", 30},
                                                         {"DE:zone30", 30},
                                                         {"FR:rural", 80},
                                                         {"RO:urban", 50},
                                                         {"RO:rural", 90},
                                                         {"RU:urban", 60},
                                                         {"RU:living_street", 20},
                                                         {"GB:nsl_single", 96.56064},
                                                         {"GB:nsl_dual", 112.65408},
                                                         {"UK:motorway", 112.65408},
                                                         {"BE-VLG:rural", 70},
                                                         {"XX:urban", 50},
                                                         {"XX:rural", 90},
                                                         {"walk", 5},
                                                         {"none", 130},
                                                         {"50;70", 50},
                                                         {"DE:urban;DE:rural", 50},
                                                         {"IT:motorway", 130}})
        EXPECT_NEAR(speedKmhOf(entry.text).value_or(-1.0), entry.kmh, 1e-6) << entry.text;
    for (const char* text :
         {"", "signals", "variable", "implicit", "fast", "DE:", ":", "DE:nonsense", "0", "-50", "999"})
        EXPECT_FALSE(speedKmhOf(text)) << text;
    EXPECT_EQ(traitsOf({{"highway", "primary"}, {"maxspeed", "signals"}})->speedKmh, 80.0);
    EXPECT_EQ(traitsOf({{"highway", "primary"}, {"source:maxspeed", "DE:urban"}})->speedKmh, 50.0);
    EXPECT_EQ(traitsOf({{"highway", "primary"}, {"source:maxspeed", "sign"}})->speedKmh, 80.0);
    const auto two =
        traitsOf({{"highway", "primary"}, {"maxspeed:forward", "70"}, {"maxspeed:backward", "50"}});
    EXPECT_EQ(two->speedKmh, 70.0);
    EXPECT_EQ(two->laneKmh(), std::pair(70.0, 50.0));
    EXPECT_EQ(two->reversed().laneKmh(), std::pair(50.0, 70.0));
    const auto one = traitsOf(
        {{"highway", "primary"}, {"oneway", "-1"}, {"maxspeed:forward", "70"}, {"maxspeed:backward", "50"}});
    EXPECT_EQ(one->speedKmh, 50.0);
}

TEST(StreetTraits, SurfaceAndMarkingsTellWhatIsPainted)
{
    EXPECT_TRUE(traitsOf({{"highway", "primary"}})->hasCentreMark);
    EXPECT_FALSE(traitsOf({{"highway", "primary"}, {"surface", "gravel"}})->hasCentreMark);
    EXPECT_FALSE(traitsOf({{"highway", "primary"}, {"surface", "gravel"}})->hasEdgeMarks);
    EXPECT_FALSE(traitsOf({{"highway", "primary"}, {"lane_markings", "no"}})->hasCentreMark);
    EXPECT_TRUE(traitsOf({{"highway", "residential"}, {"lane_markings", "yes"}})->hasCentreMark);
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
    for (const char* kind :
         {"construction", "abandoned", "disused", "razed", "planned", "no", "bus_guideway"})
        EXPECT_FALSE(traitsOf({{"highway", kind}})) << kind;
    for (const char* key : {"proposed", "abandoned", "disused", "demolished"})
        EXPECT_FALSE(traitsOf({{"highway", "primary"}, {key, "yes"}})) << key;
    EXPECT_TRUE(traitsOf({{"highway", "primary"}, {"construction", "minor"}}));
    EXPECT_TRUE(traitsOf({{"highway", "service"}, {"access", "private"}}));
    EXPECT_FALSE(traitsOf({{"highway", "service"}, {"smoothness", "impassable"}}));
    EXPECT_TRUE(traitsOf({{"highway", "service"}, {"smoothness", "bad"}}));
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
