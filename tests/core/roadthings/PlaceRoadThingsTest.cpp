// SPDX-License-Identifier: Apache-2.0
// Signals and objects on a straight road along x, with places worked by hand.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "scenery/models/ModelCheck.h"
#include "scenery/roads/things/RoadThings.h"
#include "scenery/roads/things/SignCodes.h"

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
    const auto things =
        roads::placeRoadThings(osgRoads::core::PlacedNetwork(network), [](double, double) { return -9.0; });
    // Rail: 3 pieces. Bridge: two parapets, a deck, two piers. Tunnel: tube and lights.
    EXPECT_EQ(things.own.size(), 3U + 5U + 2U);
    for (const auto& own : things.own)
    {
        EXPECT_EQ(scenery::models::defectOf(own.model), "");
        EXPECT_TRUE(scenery::models::isClosed(own.model.mesh, "line"));
    }
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
    EXPECT_EQ(faceOf("OpenDRIVE", "1000003", "-1", 4.0).second, -1); // painted on the road
}
