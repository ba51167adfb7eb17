// SPDX-License-Identifier: Apache-2.0
// The paving of junctions that are made from maps: in one piece, without steps, and nothing grows on it.
#include "JunctionPaving.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <osgRoads/core/read/ReadNetwork.h>
#include <osgRoads/core/write/WriteNetwork.h>

#include "MadeStreets.h"
#include "TestFolder.h"
#include "scenery/roads/BareGround.h"

namespace
{

using namespace osgRoads::core;

/// Streets of 90 m from one node, by the directions in which they lie, degrees.
struct Star
{
    const char* name;
    std::vector<std::pair<double, std::vector<std::pair<const char*, const char*>>>> arms;
};

MadeMap mapOf(const Star& star)
{
    MadeMap map;
    const int middle = map.node(0.0, 0.0);
    for (const auto& [degrees, tags] : star.arms)
    {
        const double angle = degrees * 3.14159265358979 / 180.0;
        const int end = map.node(90.0 * std::cos(angle), 90.0 * std::sin(angle));
        map.way({middle, end}, tags);
    }
    return map;
}

MadeMap roundabout()
{
    MadeMap map;
    std::vector<int> ring;
    for (int i = 0; i < 12; ++i)
        ring.push_back(map.node(20.0 * std::cos(i * 0.5236), 20.0 * std::sin(i * 0.5236)));
    ring.push_back(ring.front());
    map.way(ring, {{"highway", "secondary"}, {"junction", "roundabout"}});
    map.way({ring[0], map.node(120.0, 0.0)}, {{"highway", "secondary"}});
    map.way({ring[4], map.node(-60.0, 104.0)}, {{"highway", "residential"}, {"sidewalk", "both"}});
    map.way({ring[8], map.node(-60.0, -104.0)}, {{"highway", "primary"}});
    return map;
}

double slope(double eastM, double northM)
{
    return 1000.0 + 0.05 * eastM + 0.03 * northM;
}

PlacedNetwork placed(const RoadNetwork& network, const testsupport::TestFolder& folder)
{
    const auto file = folder / "roads.xodr";
    EXPECT_TRUE(writeNetwork(network, file));
    auto read = readNetwork(file);
    EXPECT_TRUE(read && read->problems.empty());
    return PlacedNetwork(std::make_shared<const RoadNetwork>(std::move(read->network)));
}

PavingFaults faultsOf(const PlacedNetwork& network)
{
    const DrawnRoads drawn(buildRoadMesh(network));
    PavingFaults faults;
    const auto isBare = [&](const glm::dvec3& place) { return scenery::isBareByRoads(network, place); };
    for (const JunctionPlace& place : junctionPlaces(network))
        lookAlong(drawn, place.middle, place.reachM, isBare, faults);
    return faults;
}

std::vector<Star> stars()
{
    return {
        {"T",
         {{0, {{"highway", "tertiary"}}},
          {180, {{"highway", "tertiary"}}},
          {270, {{"highway", "residential"}, {"sidewalk", "both"}}}}},
        {"X",
         {{0, {{"highway", "primary"}}},
          {180, {{"highway", "primary"}}},
          {85, {{"highway", "secondary"}}},
          {270, {{"highway", "secondary"}}}}},
        {"Y",
         {{90, {{"highway", "secondary"}}},
          {210, {{"highway", "tertiary"}}},
          {330, {{"highway", "secondary"}}}}},
        {"acute",
         {{0, {{"highway", "secondary"}}},
          {180, {{"highway", "secondary"}}},
          {28, {{"highway", "unclassified"}}}}},
        {"five",
         {{0, {{"highway", "secondary"}}},
          {70, {{"highway", "residential"}}},
          {150, {{"highway", "tertiary"}}},
          {215, {{"highway", "secondary"}}},
          {290, {{"highway", "service"}}}}},
        {"slip",
         {{0, {{"highway", "trunk"}}},
          {180, {{"highway", "trunk"}}},
          {25, {{"highway", "trunk_link"}, {"oneway", "yes"}}}}},
        {"widths",
         {{0, {{"highway", "primary"}, {"lanes", "4"}}},
          {180, {{"highway", "primary"}, {"lanes", "2"}}},
          {90, {{"highway", "service"}, {"width", "3"}}}}},
    };
}

/// Two one-way streets that come together at an acute angle, or part.
struct Merge
{
    const char* name;
    MadeMap::MapTags one, other, on;
};

std::vector<Merge> merges()
{
    return {
        {"slip road",
         {{"highway", "motorway"}, {"oneway", "-1"}},
         {{"highway", "motorway_link"}, {"oneway", "-1"}},
         {{"highway", "motorway"}, {"oneway", "yes"}}},
        {"carriageways",
         {{"highway", "primary"}, {"oneway", "-1"}},
         {{"highway", "primary"}, {"oneway", "yes"}},
         {{"highway", "primary"}}},
        {"two to one",
         {{"highway", "secondary"}, {"oneway", "-1"}},
         {{"highway", "secondary"}, {"oneway", "-1"}},
         {{"highway", "secondary"}, {"oneway", "yes"}}},
        {"one to two",
         {{"highway", "secondary"}, {"oneway", "-1"}, {"lanes", "1"}},
         {{"highway", "secondary"}, {"oneway", "-1"}, {"lanes", "1"}},
         {{"highway", "secondary"}, {"oneway", "yes"}, {"lanes", "2"}}},
        {"fork",
         {{"highway", "trunk"}, {"oneway", "yes"}},
         {{"highway", "trunk_link"}, {"oneway", "yes"}},
         {{"highway", "trunk"}, {"oneway", "-1"}}},
    };
}

Star starOf(const Merge& merge, double angleDeg, double turnDeg)
{
    return {merge.name,
            {{0.0, merge.on}, {180.0 + turnDeg, merge.one}, {180.0 + turnDeg - angleDeg, merge.other}}};
}

/// Blocks of about 90 m with streets of eleven kinds, none of them straight on.
MadeMap town()
{
    constexpr int kSide = 4;
    const std::vector<std::vector<std::pair<const char*, const char*>>> kinds = {
        {{"highway", "residential"}, {"sidewalk", "both"}},
        {{"highway", "tertiary"}},
        {{"highway", "secondary"}, {"sidewalk", "right"}},
        {{"highway", "residential"}, {"oneway", "yes"}},
        {{"highway", "service"}},
        {{"highway", "primary"}},
        {{"highway", "unclassified"}},
        {{"highway", "living_street"}, {"sidewalk", "left"}},
        {{"highway", "secondary"}, {"lanes", "4"}},
        {{"highway", "residential"}, {"width", "3.5"}},
        {{"highway", "trunk"}},
    };
    std::uint32_t state = 20;
    const auto random = [&] { return state = state * 1664525u + 1013904223u, state >> 8; };
    MadeMap map;
    std::vector<int> nodes;
    for (int i = 0; i < kSide * kSide; ++i)
        nodes.push_back(
            map.node(90.0 * (i % kSide) + random() % 300 / 10.0, 90.0 * (i / kSide) + random() % 300 / 10.0));
    for (int i = 0; i < kSide * kSide; ++i)
    {
        const auto at = static_cast<std::size_t>(i);
        if (i % kSide + 1 < kSide) map.way({nodes[at], nodes[at + 1]}, kinds[random() % kinds.size()]);
        if (i + kSide < kSide * kSide)
            map.way({nodes[at], nodes[at + kSide]}, kinds[random() % kinds.size()]);
    }
    return map;
}

} // namespace

TEST(JunctionPaving, SmallMapsHaveNeitherStepNorHoleNorPlantOnPaving)
{
    const testsupport::TestFolder folder("paving");
    for (const Star& star : stars())
    {
        const PavingFaults faults = faultsOf(placed(streetsOf(mapOf(star), slope).network, folder));
        EXPECT_GT(faults.samples, 5000u) << star.name;
        EXPECT_EQ(faults.count(), 0u) << star.name << ": " << faults;
    }
    const PavingFaults faults = faultsOf(placed(streetsOf(roundabout(), slope).network, folder));
    EXPECT_EQ(faults.count(), 0u) << "roundabout: " << faults;
}

TEST(JunctionPaving, OneWayStreetsThatMergeLeaveNoHole)
{
    const testsupport::TestFolder folder("paving");
    for (const Merge& merge : merges())
        for (const double angleDeg : {10.0, 24.0})
            for (const double turnDeg : {0.0, 0.5 * angleDeg})
            {
                const PavingFaults faults = faultsOf(
                    placed(streetsOf(mapOf(starOf(merge, angleDeg, turnDeg)), slope).network, folder));
                EXPECT_GT(faults.samples, 5000u) << merge.name;
                EXPECT_EQ(faults.count(), 0u) << merge.name << " at " << angleDeg << " degrees, turned by "
                                              << turnDeg << ": " << faults;
            }
}

TEST(JunctionPaving, ATownOfStreetsOfAllKindsHasNone)
{
    const testsupport::TestFolder folder("paving");
    const PavingFaults faults = faultsOf(placed(streetsOf(town(), slope).network, folder));
    EXPECT_GT(faults.samples, 100000u);
    EXPECT_EQ(faults.count(), 0u) << faults << " in the town";
}

TEST(JunctionPaving, TheSectionsSeeARaisedEdgeAndMissingPaving)
{
    const testsupport::TestFolder folder("paving");
    const RoadNetwork sound = streetsOf(mapOf(stars()[1]), slope).network;
    ASSERT_EQ(faultsOf(placed(sound, folder)).count(), 0u);
    const auto isEdge = [](const Road& road)
    {
        return !road.sections.front().left.empty() &&
               road.sections.front().left.front().type == LaneType::special;
    };
    {
        RoadNetwork raised = sound;
        const auto edge = std::find_if(raised.roads.begin(), raised.roads.end(), isEdge);
        ASSERT_NE(edge, raised.roads.end());
        std::vector<Cubic> pieces = edge->elevation.pieces();
        for (Cubic& piece : pieces)
            piece.a += 0.05;
        edge->elevation = CubicProfile(std::move(pieces));
        EXPECT_GT(faultsOf(placed(raised, folder)).steps, 0u);
    }
    // As it was before crossings had edges: verges begin within the shoulders, and are paved in places.
    RoadNetwork bare = sound;
    for (Road& road : bare.roads)
        if (isEdge(road))
        {
            LaneSection& section = road.sections.front();
            section.left.clear();
            std::erase_if(section.right, [](const Lane& lane) { return !isForCars(lane.type); });
        }
    EXPECT_GT(faultsOf(placed(bare, folder)).holes, 0u);
    // Grass that only keeps off the lanes' borders themselves would stand on nothing else than paving.
    const PlacedNetwork network = placed(sound, folder);
    PavingFaults faults;
    lookAlong(
        DrawnRoads(buildRoadMesh(network)), junctionPlaces(network).front().middle, 10.0,
        [](const glm::dvec3&) { return false; }, faults);
    EXPECT_EQ(faults.planted, faults.samples);
}
