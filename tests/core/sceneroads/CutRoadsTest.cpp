// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/CutRoads.h"

#include <cmath>
#include <memory>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <osgRoads/core/read/ReadNetwork.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using osgRoads::core::PlacedNetwork;
using scenery::RoadCutShape;

/// 600 m along x at y = 500, 7 m wide, banked, climbing by 2 %; a bridge from 300 to 360 m.
std::shared_ptr<PlacedNetwork> bankedRoad(double fromHeightM, double bankRad = 0.05,
                                          const std::string& structure = "bridge")
{
    const std::string lane = R"(<width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane>)";
    const std::string text =
        R"(<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="600" junction="-1">
<planView><geometry s="0" x="200" y="500" hdg="0" length="600"><line/></geometry></planView>
<elevationProfile><elevation s="0" a=")" +
        std::to_string(fromHeightM) + R"(" b="0.02" c="0" d="0"/></elevationProfile>
<lateralProfile><superelevation s="0" a=")" +
        std::to_string(bankRad) + R"(" b="0" c="0" d="0"/></lateralProfile>
<lanes><laneSection s="0"><left><lane id="1" type="driving" level="false">)" +
        lane + R"(</left><center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false">)" +
        lane + R"(</right></laneSection></lanes>
<objects><)" +
        structure + R"( id="b" type="concrete" s="300" length="60"/></objects></road></OpenDRIVE>)";
    auto read = osgRoads::core::parseNetwork(text, "banked.xodr");
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    return std::make_shared<PlacedNetwork>(
        std::make_shared<osgRoads::core::RoadNetwork>(std::move(read->network)));
}

/// Hills on a plane, 30 m a sample, with room for samples 1.9 m apart.
std::shared_ptr<RoamTile> hillTile()
{
    return std::make_shared<RoamTile>(PlacedTile(
        testsupport::hills(33, 33), PlacedTileOptions{.placement = Placement::planar, .gridExponent = 4}));
}

double groundM(const RoamTile& tile, const glm::dvec3& place)
{
    return groundAt(tile.tile, place.x, place.y)->position.z;
}

/// The depth of the ground below the road: least and most over its lanes, but for the bridge and the road's
/// ends.
struct Depths
{
    double leastM = 1e9, mostM = -1e9;
};
Depths depthsUnder(const RoamTile& tile, const PlacedNetwork& roads)
{
    Depths depths;
    for (double s = 5.0; s < 595.0; s += 0.7)
        for (double t = -3.5; t <= 3.5; t += 0.5)
        {
            if (s > 295.0 && s < 365.0) continue;
            const glm::dvec3 place = roads.surfacePoint(0, s, t);
            depths.leastM = std::min(depths.leastM, place.z - groundM(tile, place));
            depths.mostM = std::max(depths.mostM, place.z - groundM(tile, place));
        }
    return depths;
}

viewlod::ViewState viewAlong(const glm::dvec3& eye)
{
    return viewlod::ViewState::fromMatrices(
        glm::lookAt(eye, eye + glm::dvec3(1.0, 0.0, -0.1), {0.0, 0.0, 1.0}),
        glm::perspective(1.0, 1.25, 0.5, 1e5), 640, 512);
}

} // namespace

TEST(CutRoads, GroundIsABedUnderBankedLanesInHills)
{
    const auto tile = hillTile();
    const auto roads = bankedRoad(430.0);
    TileEditor editor(tile);
    const auto cut = scenery::cutRoads(editor, *roads);
    ASSERT_TRUE(cut) << cut.error().message();
    RecordProperty("samplesPerMetre", std::to_string(double(cut->samplesChanged) / 540.0));
    const Depths depths = depthsUnder(*tile, *roads);
    EXPECT_GT(depths.leastM, 0.3);
    // Triangles 1.9 m long span the kink between banked lane and verge: 0.5 m + (0.05 + 0.06) · 0.95 m.
    EXPECT_LT(depths.mostM, 0.61);
}

TEST(CutRoads, AShallowBedIsSeenAsTooShallow) // the test above can fail
{
    const auto tile = hillTile();
    const auto roads = bankedRoad(430.0);
    TileEditor editor(tile);
    RoadCutShape shallow;
    shallow.bed.depthM = 0.1;
    ASSERT_TRUE(scenery::cutRoads(editor, *roads, shallow));
    EXPECT_LT(depthsUnder(*tile, *roads).leastM, 0.3);
}

/// How far the ground lies below a road on a high embankment, at most, in the last 3 m before its bridge.
double gapBeforeBridgeM(const RoadCutShape& shape)
{
    const auto tile = hillTile();
    const auto roads = bankedRoad(520.0, 0.0);
    TileEditor editor(tile);
    EXPECT_TRUE(scenery::cutRoads(editor, *roads, shape));
    double most = 0.0;
    for (double beforeM = 0.1; beforeM < 3.0; beforeM += 0.2)
        for (const double s : {300.0 - beforeM, 360.0 + beforeM})
        {
            const glm::dvec3 place = roads->surfacePoint(0, s, 0.0);
            most = std::max(most, place.z - groundM(*tile, place));
        }
    return most;
}

TEST(CutRoads, TheGroundCarriesTheRoadUpToItsBridge)
{
    EXPECT_LT(gapBeforeBridgeM({}), 0.6);
    RoadCutShape without;
    without.abutmentSamples = 0.0;
    EXPECT_GT(gapBeforeBridgeM(without), 1.0) << "the control: ground that falls before the bridge is seen";
}

/// How far the ground of a strip beside a road, 11 to 15 m from its middle, has moved by the cut.
double movedBesideM(const osgTerrainROAM::core::Earthworks* water)
{
    const auto tile = hillTile(), before = hillTile();
    const auto roads = bankedRoad(430.0);
    TileEditor editor(tile);
    EXPECT_TRUE(scenery::cutRoads(editor, *roads, {}, water));
    double moved = 0.0;
    for (double s = 60.0; s < 240.0; s += 3.0)
        for (const double t : {11.0, 13.0, 15.0})
        {
            const glm::dvec3 place = roads->surfacePoint(0, s, t);
            moved = std::max(moved, std::abs(groundM(*tile, place) - groundM(*before, place)));
        }
    return moved;
}

TEST(CutRoads, SlopesStayOutOfWater)
{
    const auto roads = bankedRoad(430.0);
    osgTerrainROAM::core::Earthwork river;
    river.riseM = 0.5;
    river.widthM = 14.0;
    for (double s = 30.0; s <= 280.0; s += 5.0)
    {
        if (river.paths.empty()) river.paths.emplace_back(), river.heightsM.emplace_back();
        river.paths.front().emplace_back(roads->surfacePoint(0, s, 13.0));
        river.heightsM.front().push_back(400.0);
    }
    const osgTerrainROAM::core::Earthworks water({river}, 0.0,
                                                 [](const glm::dvec2&) { return std::optional<double>(); });
    EXPECT_LT(movedBesideM(&water), 0.02);
    EXPECT_GT(movedBesideM(nullptr), 0.5); // the control: without water the slope lies there
}

TEST(CutRoads, GroundLiesBelowTheLowSideOfASteepBank)
{
    const auto tile = hillTile();
    const auto roads = bankedRoad(430.0, 0.8);
    TileEditor editor(tile);
    ASSERT_TRUE(scenery::cutRoads(editor, *roads));
    EXPECT_GT(depthsUnder(*tile, *roads).leastM, 0.2);
}

TEST(CutRoads, ABedThatFollowsASteepBankComesThroughItsLowSide) // the test above can fail
{
    const auto tile = hillTile();
    const auto roads = bankedRoad(430.0, 0.8);
    RoadCutShape followsTheBank;
    followsTheBank.sampleM = 0.0;
    const auto bandAt = [&](double lateralM)
    {
        const glm::dvec3 edge = roads->surfacePoint(0, 100.0, -3.5);
        return scenery::roadBand(*roads, tile->tile.frame(), followsTheBank,
                                 edge + glm::dvec3(0.0, lateralM, 0.0));
    };
    // A triangle from the verge to the bank, 1.9 m long, at the lanes' edge.
    const double chordM = 0.5 * (bandAt(-0.95).highM + bandAt(0.95).highM);
    EXPECT_GT(chordM, roads->surfacePoint(0, 100.0, -3.5).z - 0.2);
}

TEST(CutRoads, GroundFarAwayAndUnderABridgeStaysAsItWas)
{
    const auto before = hillTile(), tile = hillTile();
    const auto roads = bankedRoad(600.0);
    TileEditor editor(tile);
    ASSERT_TRUE(scenery::cutRoads(editor, *roads));
    const RoadCutShape shape;
    for (double x = 20.0; x < 940.0; x += 7.0)
        for (double y = 20.0; y < 940.0; y += 7.0)
        {
            const bool isFar = x < 150.0 || x > 850.0 || std::abs(y - 500.0) > shape.reachM + 10.0;
            if (!isFar) continue;
            EXPECT_NEAR(groundM(*tile, {x, y, 0.0}), groundM(*before, {x, y, 0.0}), 1e-3);
        }
    // Abutments 30 m away and 118 m high leave a thousandth of their height.
    EXPECT_NEAR(groundM(*tile, {530.0, 500.0, 0.0}), groundM(*before, {530.0, 500.0, 0.0}), 0.15);
}

TEST(CutRoads, GroundNeverReachesThroughALowBridge)
{
    auto field = testsupport::hills(33, 33);
    for (float& heightM : field.heightsM)
        heightM *= 0.02f;
    const auto tile = std::make_shared<RoamTile>(
        PlacedTile(field, PlacedTileOptions{.placement = Placement::planar, .gridExponent = 4}));
    // 2 m below the ground in the middle of the bridge
    const auto roads = bankedRoad(groundM(*tile, {530.0, 500.0, 0.0}) - 6.6 - 2.0, 0.05);
    TileEditor editor(tile);
    ASSERT_TRUE(scenery::cutRoads(editor, *roads));
    for (double s = 290.0; s < 370.0; s += 0.7)
        for (double t = -3.5; t <= 3.5; t += 0.5)
        {
            const glm::dvec3 place = roads->surfacePoint(0, s, t);
            EXPECT_LT(groundM(*tile, place), place.z - 0.3) << s << " " << t;
        }
}

TEST(CutRoads, GroundThatCoversATunnelStaysAsItWas)
{
    const auto before = hillTile(), tile = hillTile();
    const double deepM = groundM(*before, {530.0, 500.0, 0.0}) - 6.6 - 30.0;
    TileEditor editor(tile);
    ASSERT_TRUE(scenery::cutRoads(editor, *bankedRoad(deepM, 0.05, "tunnel")));
    EXPECT_NEAR(groundM(*tile, {530.0, 500.0, 0.0}), groundM(*before, {530.0, 500.0, 0.0}), 1e-3);
}

TEST(CutRoads, EveryMeshOfTheTileKeepsItsPromises)
{
    const auto tile = hillTile();
    const auto roads = bankedRoad(430.0);
    TileEditor editor(tile);
    ASSERT_TRUE(scenery::cutRoads(editor, *roads));
    RoamMesh mesh{SplitBounds(tile)};
    for (double s = 10.0; s < 600.0; s += 145.0)
    {
        const glm::dvec3 eye = roads->surfacePoint(0, s, -1.75) + glm::dvec3(0.0, 0.0, 1.3);
        const auto view = viewAlong(eye);
        const auto said = mesh.refine(view, {.errorTolerancePx = 1.0});
        const DrawnMeshReport report = checkDrawnMesh(*tile, mesh.drawn(), &view);
        EXPECT_EQ(report.tJunctions, 0u);
        EXPECT_EQ(report.cracks, 0u);
        EXPECT_LE(report.maxErrorPx, said.tolerancePx);
    }
}

TEST(CutRoads, RoadsBeyondTheTileAreRefused)
{
    const auto tile = hillTile();
    const auto roads = bankedRoad(430.0);
    TileEditor editor(tile);
    const auto moved = std::make_shared<RoamTile>(
        PlacedTile(testsupport::hills(3, 3), PlacedTileOptions{.placement = Placement::planar}));
    TileEditor other(moved);
    const auto cut = scenery::cutRoads(other, *roads);
    ASSERT_FALSE(cut);
    EXPECT_NE(cut.error().message().find("beyond the terrain"), std::string::npos);
}

namespace
{

/// Two level roads along x, 7 m wide, 500 m long, at two places of y.
std::shared_ptr<PlacedNetwork> twoRoads(const glm::dvec2& low, const glm::dvec2& high)
{
    const auto road = [](const std::string& id, const glm::dvec2& at)
    {
        const std::string lane = R"(<width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane>)";
        return R"(<road id=")" + id +
               R"(" length="500" junction="-1"><planView><geometry s="0" x="200" y=")" +
               std::to_string(at.x) + R"(" hdg="0" length="500"><line/></geometry></planView>)" +
               R"(<elevationProfile><elevation s="0" a=")" + std::to_string(at.y) +
               R"(" b="0" c="0" d="0"/></elevationProfile><lanes><laneSection s="0"><left>)" +
               R"(<lane id="1" type="driving" level="false">)" + lane +
               R"(</left><center><lane id="0" type="none" level="false"/></center><right>)" +
               R"(<lane id="-1" type="driving" level="false">)" + lane +
               "</right></laneSection></lanes></road>";
    };
    auto read = osgRoads::core::parseNetwork(R"(<OpenDRIVE><header revMajor="1" revMinor="7"/>)" +
                                                 road("1", low) + road("2", high) + "</OpenDRIVE>",
                                             "two.xodr");
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    return std::make_shared<PlacedNetwork>(
        std::make_shared<osgRoads::core::RoadNetwork>(std::move(read->network)));
}

/// Level ground at a height, cut to two roads.
std::shared_ptr<RoamTile> levelTile(float heightM, const PlacedNetwork& roads)
{
    auto field = testsupport::hills(33, 33);
    std::fill(field.heightsM.begin(), field.heightsM.end(), heightM);
    field.heightsM.front() += 100.0F; // so that heights have a range
    auto tile = std::make_shared<RoamTile>(
        PlacedTile(field, PlacedTileOptions{.placement = Placement::planar, .gridExponent = 4}));
    TileEditor editor(tile);
    EXPECT_TRUE(scenery::cutRoads(editor, roads));
    return tile;
}

} // namespace

TEST(CutRoads, TheGroundBetweenTwoStreetsInACuttingIsNoHeap)
{
    const auto tile = levelTile(440.0F, *twoRoads({500.0, 430.0}, {526.0, 432.0}));
    double lastM = 0.0, mostStepM = 0.0;
    for (double y = 506.5; y <= 519.5; y += 0.5) // from verge to verge
    {
        const double heightM = groundM(*tile, {450.0, y, 0.0});
        EXPECT_GT(heightM, 429.4) << y;
        EXPECT_LT(heightM, 432.6) << y; // slopes of 1 : 1.5 would meet 4 m above the lower one
        mostStepM = std::max(mostStepM, y > 506.5 ? std::abs(heightM - lastM) : 0.0);
        lastM = heightM;
    }
    EXPECT_LT(mostStepM, 0.5);
    EXPECT_NEAR(groundM(*tile, {450.0, 580.0, 0.0}), 440.0, 0.05);
}

TEST(CutRoads, BothOfTwoCloseStreetsAtDifferentHeightsAreCarried)
{
    const auto roads = twoRoads({500.0, 430.0}, {510.0, 434.0}); // 3 m between them, and 4 m of height
    const auto tile = levelTile(432.0F, *roads);
    for (double s = 20.0; s < 480.0; s += 3.1)
    {
        const glm::dvec3 low = roads->surfacePoint(0, s, 0.0), high = roads->surfacePoint(1, s, 0.0);
        EXPECT_NEAR(low.z - groundM(*tile, low), 0.5, 0.2) << s;
        EXPECT_NEAR(high.z - groundM(*tile, high), 0.5, 0.2) << s;
        const glm::dvec3 edge = roads->surfacePoint(0, s, 3.5); // of the lower one, to the higher
        EXPECT_GT(edge.z - groundM(*tile, edge), 0.0) << s;
    }
}
