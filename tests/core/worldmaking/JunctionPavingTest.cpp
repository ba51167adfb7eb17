// SPDX-License-Identifier: Apache-2.0
// The paving of junctions that are made from maps: in one piece, without steps, and nothing grows on it.
#include "JunctionPaving.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
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

constexpr double kLaneLengthM = 60.0;

/// A straight road with one lane, 3.5 m to the right of its line, and what lies beside it.
struct StraightLane
{
    int id = 0;
    glm::dvec2 from{0.0};
    double headingRad = 0.0;
    std::string tags, lanes, objects = {};
};

std::string xmlOf(const StraightLane& road)
{
    const std::string length = std::to_string(kLaneLengthM);
    return "<road id=\"" + std::to_string(road.id) + "\" length=\"" + length + "\" " + road.tags +
           "<planView><geometry s=\"0\" x=\"" + std::to_string(road.from.x) + "\" y=\"" +
           std::to_string(road.from.y) + "\" hdg=\"" + std::to_string(road.headingRad) + "\" length=\"" +
           length +
           "\"><line/></geometry></planView><lanes><laneSection s=\"0\"><center>"
           "<lane id=\"0\" type=\"none\"/></center><right><lane id=\"-1\" type=\"driving\">"
           "<width sOffset=\"0\" a=\"3.5\" b=\"0\" c=\"0\" d=\"0\"/></lane>" +
           road.lanes + "</right></laneSection></lanes>" + road.objects + "</road>";
}

PlacedNetwork networkOf(const std::vector<StraightLane>& roads)
{
    std::string text = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>";
    for (const StraightLane& road : roads)
        text += xmlOf(road);
    auto read = parseNetwork(text + "<junction id=\"9\"/></OpenDRIVE>", "test.xodr");
    EXPECT_TRUE(read);
    return PlacedNetwork(std::make_shared<const RoadNetwork>(std::move(read->network)));
}

/// A road along x, and another that leaves it on its right side at `shiftM`. Both come from a junction.
PlacedNetwork partingLanes(double angleDeg, double shiftM, const std::string& objects = {})
{
    constexpr double kBackM = 20.0;
    const double angle = angleDeg * 3.14159265358979 / 180.0;
    const std::string tags =
        "junction=\"-1\"><link><predecessor elementType=\"junction\" elementId=\"9\"/></link>";
    const glm::dvec2 from(shiftM - kBackM * std::cos(angle), -3.5 + kBackM * std::sin(angle));
    return networkOf({{1, {-kBackM, 0.0}, 0.0, tags, "", objects}, {2, from, -angle, tags, "", objects}});
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

TEST(JunctionPaving, VergesFillAnIslandAsFarAsItsTip)
{
    for (const double angleDeg : {4.0, 7.0, 12.0, 20.0})
        for (const double shiftM : {0.0, 0.5, 1.0, 1.5})
        {
            const double slopeOfOther = std::tan(angleDeg * 3.14159265358979 / 180.0);
            const DrawnRoads drawn(buildRoadMesh(partingLanes(angleDeg, shiftM)));
            std::size_t places = 0, open = 0;
            glm::dvec2 last(0.0);
            // Both verges are 2.5 m wide.
            const double endM = shiftM + std::min(4.8 / slopeOfOther, 25.0);
            for (double along = shiftM - 2.0; along < endM; along += 0.1)
            {
                const double gapM = std::max((along - shiftM) * slopeOfOther, 0.0);
                for (double across = -0.5; across < gapM + 0.5; across += 0.1)
                    if (++places; !drawn.at({along, -3.5 - across})) ++open, last = {along, across};
            }
            EXPECT_GT(places, 3000u);
            EXPECT_EQ(open, 0u) << angleDeg << " degrees, " << shiftM << " m, the last at " << last.x << ", "
                                << last.y;
        }
}

/// The deck of a bridge lies 5 cm lower than its lanes, and its edge stands 0.3 m beside them where there is
/// room.
TEST(JunctionPaving, BridgesThatPartArePavedBetweenTheirLanes)
{
    const std::string bridge =
        "<objects><bridge id=\"b\" s=\"0\" length=\"60\" type=\"concrete\"/></objects>";
    for (const double angleDeg : {3.0, 5.0, 8.0, 12.0, 20.0})
        for (const double shiftM : {0.0, 1.0})
        {
            const double slopeOfOther = std::tan(angleDeg * 3.14159265358979 / 180.0);
            const DrawnRoads drawn(buildRoadMesh(partingLanes(angleDeg, shiftM, bridge)));
            for (double along = shiftM + 0.2; (along - shiftM) * slopeOfOther < 0.6; along += 0.1)
                for (double across = 0.0; across < (along - shiftM) * slopeOfOther; across += 0.02)
                {
                    const auto sample = drawn.at({along, -3.5 - across});
                    ASSERT_TRUE(sample) << angleDeg << " degrees, " << along << ", " << across;
                    ASSERT_TRUE(sample->isPaved()) << angleDeg << " degrees, " << along << ", " << across;
                    ASSERT_GT(sample->heightM, -0.045) << angleDeg << " degrees, " << along << ", " << across;
                }
            // Beyond, where edges stand, there is air.
            EXPECT_FALSE(drawn.at({shiftM + 3.0 / slopeOfOther, -5.0})) << angleDeg;
        }
}

TEST(JunctionPaving, ABorderThatALaneCoversInPartIsCutThere)
{
    for (const double overM : {0.002, 0.02, 0.08, 0.16})
    {
        const std::string border =
            "<lane id=\"-2\" type=\"border\"><width sOffset=\"0\" a=\"0.35\" b=\"0\" "
            "c=\"0\" d=\"0\"/><height sOffset=\"0\" inner=\"0.1\" outer=\"0.1\"/></lane>";
        const std::string tags = "junction=\"9\">";
        const DrawnRoads drawn(
            buildRoadMesh(networkOf({{1, {0.0, 0.0}, 0.0, tags, ""}, {2, {0.0, overM}, 0.0, tags, border}})));
        for (double across = -0.3; across < 0.33 - overM; across += 0.01)
        {
            const auto sample = drawn.at({30.0, -3.5 - across});
            ASSERT_TRUE(sample) << overM << " m, " << across;
            const double heightM = across > 0.0 ? 0.1 : 0.0;
            if (std::fabs(across) < 0.025) continue; // so much overlaps
            EXPECT_NEAR(sample->heightM, heightM, 1e-3) << overM << " m, " << across;
        }
    }
}

TEST(JunctionPaving, AVergeBehindASidewalkEndsWhereTheLanesOfAnotherRoadBegin)
{
    const std::string tags =
        "junction=\"-1\"><link><predecessor elementType=\"junction\" elementId=\"9\"/></link>";
    const std::string sidewalk =
        "<lane id=\"-2\" type=\"sidewalk\"><width sOffset=\"0\" a=\"1.5\" b=\"0\" "
        "c=\"0\" d=\"0\"/><height sOffset=\"0\" inner=\"0.12\" outer=\"0.12\"/></lane>";
    for (const double gapM : {0.1, 0.3, 0.8, 1.2, 1.6, 2.2})
    {
        const DrawnRoads drawn(buildRoadMesh(
            networkOf({{1, {0.0, 0.0}, 0.0, tags, sidewalk}, {2, {0.0, -5.0 - gapM}, 0.0, tags, ""}})));
        for (double across = 0.03; across < gapM + 3.4; across += 0.01)
        {
            const auto sample = drawn.at({30.0, -5.0 - across});
            ASSERT_TRUE(sample) << gapM << " m, " << across;
            if (std::fabs(across - gapM) < 0.03) continue;
            EXPECT_EQ(sample->isPaved(), across > gapM) << gapM << " m, " << across;
        }
    }
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
    {
        // Without the paving of one corner.
        RoadNetwork open = sound;
        LaneSection& section = std::find_if(open.roads.begin(), open.roads.end(), isEdge)->sections.front();
        section.left.clear();
        std::erase_if(section.right, [](const Lane& lane) { return !isForCars(lane.type); });
        EXPECT_GT(faultsOf(placed(open, folder)).holes, 0u);
    }
    // Grass that only keeps off the lanes' borders themselves would stand on nothing else than paving.
    const PlacedNetwork network = placed(sound, folder);
    PavingFaults faults;
    lookAlong(
        DrawnRoads(buildRoadMesh(network)), junctionPlaces(network).front().middle, 10.0,
        [](const glm::dvec3&) { return false; }, faults);
    EXPECT_EQ(faults.planted, faults.samples);
}
