// SPDX-License-Identifier: Apache-2.0
// Signals and objects on a straight road along x, with places worked by hand.
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scenery/models/ModelCheck.h"
#include "scenery/roads/things/CountThings.h"
#include "scenery/roads/things/ObjectModels.h"
#include "scenery/roads/things/RoadThings.h"
#include "scenery/roads/things/SignCodes.h"
#include "scenery/roads/things/ThingObstacles.h"

namespace roads = scenery::roads;
using scenery::models::RoadModel;
using scenery::models::SignFace;

namespace
{

/// A road of 200 m along x without lanes.
osgRoads::core::Road straightRoad()
{
    osgRoads::core::Road road;
    road.id = "1";
    road.length = 200.0;
    road.isUsable = true;
    road.referenceLine = osgRoads::core::ReferenceLine(
        {osgRoads::core::PlanElement(0.0, 200.0, {0.0, 0.0}, 0.0, osgRoads::core::LineShape{})});
    return road;
}

osgRoads::core::Signal limit(double s, double t, char orientation)
{
    osgRoads::core::Signal signal;
    signal.id = "7";
    signal.country = "de";
    signal.type = "274";
    signal.value = 80.0;
    signal.s = s;
    signal.t = t;
    signal.zOffset = 1.7;
    signal.width = signal.height = 0.6;
    signal.orientation = orientation;
    return signal;
}

roads::RoadThings placed(osgRoads::core::Road road)
{
    auto network = std::make_shared<osgRoads::core::RoadNetwork>();
    network->roads.push_back(std::move(road));
    network->index();
    return roads::placeRoadThings(osgRoads::core::PlacedNetwork(network));
}

void expectNear(const glm::dvec3& value, const glm::dvec3& wanted)
{
    EXPECT_LT(glm::distance(value, wanted), 1e-9) << value.x << ' ' << value.y << ' ' << value.z;
}

} // namespace

TEST(PlaceRoadThings, ASignLooksAtTheTrafficThatItIsFor)
{
    osgRoads::core::Road road = straightRoad();
    road.signals = {limit(100.0, -4.0, '+'), limit(50.0, 4.0, '-')};
    const auto things = placed(road);
    ASSERT_EQ(things.standing.size(), 2U);
    EXPECT_EQ(things.models.size(), 1U); // equal signs share a model
    expectNear(things.standing[0].position, {100.0, -4.0, 0.0});
    expectNear(things.standing[0].axes[0], {1.0, 0.0, 0.0});
    expectNear(things.standing[1].position, {50.0, 4.0, 0.0});
    expectNear(things.standing[1].axes[0], {-1.0, 0.0, 0.0});
    EXPECT_EQ(things.models[0].number, 80);
    EXPECT_EQ(things.models[0].raisedM, 1.7);
    EXPECT_GT(things.models[0].postDepthM, 0.0);
}

TEST(PlaceRoadThings, PlatesArePitchedAndRolledOnAnUprightPost)
{
    osgRoads::core::Road road = straightRoad();
    road.signals = {limit(100.0, -4.0, '+')};
    road.signals[0].pitchRad = 0.104;
    road.signals[0].rollRad = -0.05;
    const auto things = placed(road);
    ASSERT_EQ(things.standing.size(), 1U);
    expectNear(things.standing[0].axes[2], {0.0, 0.0, 1.0});
    EXPECT_EQ(things.models[0].pitchRad, 0.1); // in hundredths
    EXPECT_EQ(things.models[0].rollRad, -0.05);
    // Where the post stands elsewhere, its own angles count.
    road.signals[0].post = osgRoads::core::Signal::Post{true, "1", 90.0, -5.0, 0.0, 0.0, 0.2, 0.0};
    EXPECT_EQ(placed(road).models[0].pitchRad, 0.2);
    EXPECT_EQ(placed(road).models[0].rollRad, 0.0);
}

TEST(PlaceRoadThings, ObjectsArePitchedAndRolledAsAWhole)
{
    osgRoads::core::Road road = straightRoad();
    osgRoads::core::RoadObject pole;
    pole.type = "pole";
    pole.s = 100.0;
    pole.t = 5.0;
    pole.height = 4.0;
    pole.pitchRad = 0.3;
    road.objects = {pole};
    pole.pitchRad = 0.0;
    pole.rollRad = 0.2;
    road.objects.push_back(pole);
    const auto things = placed(road);
    ASSERT_EQ(things.standing.size(), 2U);
    expectNear(things.standing[0].axes[2], {std::sin(0.3), 0.0, std::cos(0.3)});  // leans ahead
    expectNear(things.standing[1].axes[2], {0.0, -std::sin(0.2), std::cos(0.2)}); // leans to the right
}

TEST(PlaceRoadThings, APoleOfTheFileTakesThePlaceOfThePost)
{
    osgRoads::core::Road road = straightRoad();
    road.signals = {limit(100.0, -4.0, '+')};
    osgRoads::core::RoadObject pole;
    pole.type = "pole";
    pole.s = 100.0;
    pole.t = -4.0;
    pole.height = 2.3;
    road.objects = {pole};
    const auto things = placed(road);
    ASSERT_EQ(things.models.size(), 2U);
    EXPECT_EQ(things.models[0].postDepthM, 0.0);
    EXPECT_EQ(things.models[1].kind, RoadModel::Kind::pole);
}

TEST(PlaceRoadThings, RepeatsStandAlongTheRoad)
{
    osgRoads::core::Road road = straightRoad();
    osgRoads::core::RoadObject post;
    post.type = "guide-post";
    osgRoads::core::ObjectRepeat repeat;
    repeat.s = 0.0;
    repeat.length = 200.0;
    repeat.distance = 50.0;
    repeat.tStart = repeat.tEnd = 4.0;
    repeat.zOffsetStart = repeat.zOffsetEnd = -0.2;
    post.repeats = {repeat};
    road.objects = {post};
    const auto things = placed(road);
    ASSERT_EQ(things.standing.size(), 5U);
    expectNear(things.standing[3].position, {150.0, 4.0, -0.2});
}

TEST(PlaceRoadThings, RailsBridgesAndTunnelsAreWholeModels)
{
    osgRoads::core::Road road = straightRoad();
    osgRoads::core::RoadObject rail;
    rail.type = "railing";
    osgRoads::core::ObjectRepeat repeat;
    repeat.length = 200.0;
    repeat.tStart = repeat.tEnd = -5.0;
    repeat.heightStart = repeat.heightEnd = 0.2;
    rail.repeats = {repeat};
    road.objects = {rail};
    osgRoads::core::RoadStructure bridge, tunnel;
    bridge.s = 20.0;
    bridge.length = 60.0;
    tunnel.kind = osgRoads::core::StructureKind::tunnel;
    tunnel.s = 100.0;
    tunnel.length = 50.0;
    road.structures = {bridge, tunnel};
    auto network = std::make_shared<osgRoads::core::RoadNetwork>();
    network->roads.push_back(road);
    network->index();
    const auto things = roads::placeRoadThings(osgRoads::core::PlacedNetwork(network),
                                               [](const glm::dvec2&) { return -9.0; });
    // Rail: 3 pieces. Bridge: two edges with three bars each, a deck, two piers. Tunnel: tube, two walkways
    // and two portals, each with what hides the tube behind it.
    EXPECT_EQ(things.own.size(), 3U + 11U + 7U);
    EXPECT_EQ(things.lamps.size(), 2U * 5U); // every 10 m of 50, in two rows
    // Posts of both railings every 2 m of 60; the rail is too low for posts.
    EXPECT_EQ(things.standing.size(), 2U * 30U);
    for (const auto& own : things.own)
    {
        EXPECT_EQ(scenery::models::defectOf(own.model), "");
        EXPECT_TRUE(scenery::models::isClosed(own.model.mesh, "line"));
    }
}

namespace
{

osgRoads::core::RoadObject stretchOf(const char* type, double t, double height, double z)
{
    osgRoads::core::RoadObject object;
    object.type = type;
    osgRoads::core::ObjectRepeat repeat;
    repeat.length = 80.0;
    repeat.tStart = repeat.tEnd = t;
    repeat.zOffsetStart = repeat.zOffsetEnd = z;
    if (height > 0.0) repeat.heightStart = repeat.heightEnd = height;
    object.repeats = {repeat};
    return object;
}

/// Returns the lowest and the highest z, and the least and the greatest y, of the only whole model.
std::array<double, 4> extentOf(const roads::RoadThings& things)
{
    std::array<double, 4> extent{1e9, -1e9, 1e9, -1e9};
    EXPECT_EQ(things.own.size(), 1U);
    for (const auto& position : things.own.at(0).model.mesh.positions)
    {
        const glm::dvec3 at = things.own[0].origin + glm::dvec3(position);
        extent = {std::min(extent[0], at.z), std::max(extent[1], at.z), std::min(extent[2], at.y),
                  std::max(extent[3], at.y)};
    }
    return extent;
}

} // namespace

TEST(PlaceRoadThings, AGuardRailIsABeamOnPosts)
{
    osgRoads::core::Road road = straightRoad();
    road.objects = {stretchOf("guardRail", -5.0, 0.75, 0.0)};
    const auto things = placed(road);
    const auto [low, high, right, left] = extentOf(things);
    EXPECT_NEAR(high, 0.75, 1e-3);
    EXPECT_NEAR(low, -0.31, 1e-3); // its free end goes into the ground
    // On the right of a road without lanes it looks to the left: from the flange of the post on.
    EXPECT_NEAR(right, -5.0 + 0.04, 1e-3);
    EXPECT_NEAR(left, -5.0 + 0.045 + 0.081, 1e-3);
    // Every 4 m of 80, but not where its last 8 m are too low.
    EXPECT_EQ(things.standing.size(), 19U);
    EXPECT_EQ(things.models.at(0).kind, RoadModel::Kind::railPost);
    EXPECT_NEAR(things.models[0].heightM, 0.72, 1e-9);
    // Delineators beside it are no posts of it.
    osgRoads::core::RoadObject delineator = stretchOf("pole", -4.8, 1.0, 0.0);
    delineator.name = "delineator";
    delineator.repeats[0].distance = 50.0;
    road.objects.push_back(delineator);
    EXPECT_EQ(placed(road).standing.size(), 19U + 2U);
}

TEST(PlaceRoadThings, ABeamOfToldHeightAndTheFilesOwnPostsAreKept)
{
    osgRoads::core::Road road = straightRoad();
    osgRoads::core::RoadObject post = stretchOf("rail-pole", 5.0, 0.55, 0.0);
    post.repeats[0].distance = 8.0;
    road.objects = {stretchOf("railing", 5.0, 0.2, 0.35), post};
    const auto things = placed(road);
    const auto [low, high, right, left] = extentOf(things);
    EXPECT_LT(low, 0.35);
    EXPECT_NEAR(high, 0.55, 1e-3);
    EXPECT_LT(left, 5.0); // towards the road
    EXPECT_EQ(things.standing.size(), 11U);
}

TEST(PlaceRoadThings, AKerbReachesIntoTheGround)
{
    osgRoads::core::Road road = straightRoad();
    road.objects = {stretchOf("curb", 3.0, 0.0, 0.0)};
    const auto [low, high, right, left] = extentOf(placed(road));
    EXPECT_NEAR(low, -0.3, 1e-3);
    EXPECT_NEAR(high, 0.12, 1e-3);
    EXPECT_NEAR(left - right, 0.15, 1e-3);
}

TEST(PlaceRoadThings, PiersStandClearOfTheRoadBelow)
{
    osgRoads::core::Road above = straightRoad(), below = straightRoad();
    osgRoads::core::RoadStructure bridge;
    bridge.s = 60.0;
    bridge.length = 80.0;
    above.structures = {bridge};
    above.elevation = osgRoads::core::CubicProfile({{0.0, 8.0, 0.0, 0.0, 0.0}});
    below.id = "2";
    // Crosses below at x = 75, where the first pier would stand.
    below.referenceLine = osgRoads::core::ReferenceLine(
        {osgRoads::core::PlanElement(0.0, 200.0, {75.0, -100.0}, 1.5707963, osgRoads::core::LineShape{})});
    const auto piersOf = [&](bool crosses)
    {
        auto network = std::make_shared<osgRoads::core::RoadNetwork>();
        network->roads.push_back(above);
        if (crosses) network->roads.push_back(below);
        network->index();
        std::vector<double> piers;
        for (const auto& own : roads::placeRoadThings(osgRoads::core::PlacedNetwork(network),
                                                      [](const glm::dvec2&) { return 0.0; })
                                   .own)
            if (own.origin.x > 61.0) piers.push_back(own.origin.x); // the others begin with the bridge
        return piers;
    };
    const auto alone = piersOf(false), crossed = piersOf(true);
    ASSERT_EQ(alone.size(), 3U);
    ASSERT_EQ(crossed.size(), 3U);
    EXPECT_NEAR(alone[0], 75.0 - 0.6, 1e-6);
    EXPECT_NEAR(crossed[0], 75.0 + 3.0 - 0.6, 1e-6);
    EXPECT_EQ(crossed[1], alone[1]);
}

TEST(PlaceRoadThings, WordsAreWholeWords)
{
    osgRoads::core::RoadObject object;
    object.type = "pole";
    object.subtype = "streetLamp"; // not a tree
    EXPECT_FALSE(roads::isPlant(roads::ObjectWords(object)));
    EXPECT_EQ(roads::objectModel(roads::ObjectWords(object), {})->kind, RoadModel::Kind::lampPost);
    object.type = "tree";
    object.subtype.clear();
    EXPECT_TRUE(roads::isPlant(roads::ObjectWords(object)));
}

TEST(PlaceRoadThings, ASignOverALaneHangsFromAnArmOrAGantry)
{
    osgRoads::core::Road road = straightRoad();
    osgRoads::core::Lane lane;
    lane.id = -1;
    lane.type = osgRoads::core::LaneType::driving;
    lane.width = osgRoads::core::CubicProfile({{0.0, 4.0, 0.0, 0.0, 0.0}});
    osgRoads::core::LaneSection section;
    section.end = 200.0;
    section.right = {lane};
    road.sections = {section};
    road.signals = {limit(100.0, -2.0, '+'), limit(50.0, -1.0, '-')};
    for (auto& signal : road.signals)
        signal.zOffset = 5.0;
    osgRoads::core::RoadObject gantry;
    gantry.type = "gantry";
    gantry.s = 51.0;
    auto things = placed(road);
    ASSERT_EQ(things.standing.size(), 2U);
    EXPECT_EQ(things.models[0].armM, 2.75); // lanes end 2 m to the right; both sides are as far
    EXPECT_EQ(things.models[1].armM, 1.75); // against s: the left edge of the lanes is on its right
    EXPECT_GT(things.models[1].postDepthM, 0.0);
    road.objects = {gantry};
    things = placed(road);
    EXPECT_EQ(things.models[1].armM, 0.0);
    EXPECT_EQ(things.models[1].postDepthM, 0.0);
}

TEST(PlaceRoadThings, SignsOfLeftHandTrafficLookAgainstItsDirection)
{
    osgRoads::core::Road road = straightRoad();
    road.isLeftHandTraffic = true;
    road.signals = {limit(100.0, 4.0, '+')}; // beside the left lanes, which run towards greater s
    const auto things = placed(road);
    expectNear(things.standing.at(0).axes[0], {1.0, 0.0, 0.0});
}

TEST(CountThings, TellsWhatIsDrawnAndWhatIsNot)
{
    osgRoads::core::RoadNetwork network;
    network.roads.push_back(straightRoad());
    osgRoads::core::Signal unknown = limit(10.0, 0.0, '+'), line = unknown;
    unknown.type = "99999";
    line.type = "294";
    network.roads[0].signals = {limit(1.0, 0.0, '+'), limit(2.0, 0.0, '+'), unknown, line};
    osgRoads::core::RoadObject statue, tree;
    statue.type = "art";
    tree.type = "tree";
    network.roads[0].objects = {statue, tree};
    const roads::ThingCounts counts = roads::countThings(network);
    using Counts = std::map<std::string, int>;
    EXPECT_EQ(counts.models, (Counts{{"signal de 274", 2}, {"object tree", 1}}));
    EXPECT_EQ(counts.painted, (Counts{{"signal de 294", 1}}));
    EXPECT_EQ(counts.withoutModel, (Counts{{"signal de 99999", 1}, {"object art", 1}}));
}

TEST(SignCodes, KnowTheSignsOfThreeCountries)
{
    const auto faceOf = [](const char* country, const char* type, const char* subtype, double value)
    {
        osgRoads::core::Signal signal;
        signal.country = country;
        signal.type = type;
        signal.subtype = subtype;
        signal.value = value;
        const auto model = roads::signModel(signal);
        return model ? std::pair{model->face, model->number} : std::pair{SignFace::count, -1};
    };
    EXPECT_EQ(faceOf("de", "205", "-1", 0.0), (std::pair{SignFace::giveWay, 0}));
    EXPECT_EQ(faceOf("OpenDRIVE", "274", "57", 0.0), (std::pair{SignFace::limit, 70}));
    EXPECT_EQ(faceOf("se", "c", "31", 5.0), (std::pair{SignFace::limit, 50}));
    EXPECT_EQ(faceOf("cn", "shi", "", 50.0), (std::pair{SignFace::least, 50}));
    EXPECT_EQ(faceOf("de", "99999", "", 0.0).second, -1);
    EXPECT_EQ(faceOf("OpenDRIVE", "1000011", "30", 0.0).second, 0);  // a light, as netconvert writes it
    EXPECT_EQ(faceOf("OpenDRIVE", "1000003", "-1", 4.0).second, -1); // painted on the road
}

TEST(SignCodes, ATextWithoutAFaceIsABoard)
{
    osgRoads::core::Signal signal;
    signal.country = "de";
    signal.type = "1004";
    EXPECT_FALSE(roads::signModel(signal));
    signal.text = "in\\n200 m \xC3\xB6";
    const auto model = roads::signModel(signal);
    ASSERT_TRUE(model);
    EXPECT_EQ(model->kind, RoadModel::Kind::board);
    EXPECT_EQ(model->text, "IN\n200 M \xD6");
    EXPECT_TRUE(model->isWhite);
    signal.type = "310";
    EXPECT_FALSE(roads::signModel(signal)->isWhite);
}

TEST(SignCodes, LampsHaveTheArrowsOfTheirSubtype)
{
    osgRoads::core::Signal signal;
    signal.type = "1000011";
    signal.subtype = "-40";
    EXPECT_EQ(roads::signModel(signal)->arrow, RoadModel::Arrow::leftAhead);
    signal.subtype = "20";
    EXPECT_EQ(roads::signModel(signal)->arrow, RoadModel::Arrow::right);
    signal.subtype = "-1";
    EXPECT_EQ(roads::signModel(signal)->arrow, RoadModel::Arrow::none);
    signal.type = "1000001";
    signal.subtype = "20";
    EXPECT_EQ(roads::signModel(signal)->arrow, RoadModel::Arrow::none);
}

TEST(PlaceRoadThings, WhatStandsIsInTheWay)
{
    osgRoads::core::Road road = straightRoad();
    road.signals = {limit(100.0, -4.0, '+')};
    osgRoads::core::RoadObject rail;
    rail.id = "1";
    rail.type = "barrier";
    rail.name = "guardrail";
    rail.s = 0.0;
    rail.height = 0.75;
    osgRoads::core::ObjectRepeat along;
    along.s = 20.0;
    along.length = 40.0;
    along.tStart = along.tEnd = 6.0;
    along.heightStart = along.heightEnd = 0.75;
    rail.repeats = {along};
    road.objects = {rail};
    simulation::ObstacleList list;
    roads::addObstacles(placed(road), list);
    std::size_t posts = 0, rails = 0;
    for (const simulation::Obstacle& obstacle : list.obstacles())
        if (obstacle.kind == simulation::ObstacleKind::post)
        {
            ++posts;
            EXPECT_EQ(obstacle.middle, glm::dvec2(100.0, -4.0));
            EXPECT_NEAR(obstacle.highM, 2.3, 1e-9); // the top of its plate
        }
        else if (obstacle.kind == simulation::ObstacleKind::guardRail)
        {
            ++rails;
            EXPECT_NEAR(obstacle.middle.y, 6.0, 0.1);
            EXPECT_GT(obstacle.middle.x, 19.0);
            EXPECT_LT(obstacle.middle.x, 61.0);
            EXPECT_LE(obstacle.highM, 0.76);
        }
    EXPECT_EQ(posts, 1U);
    EXPECT_EQ(rails, 10U);
    // Nothing is in the way where nothing stands.
    simulation::ObstacleList none;
    roads::addObstacles(placed(straightRoad()), none);
    EXPECT_TRUE(none.obstacles().empty());
}
