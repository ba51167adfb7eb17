// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadPosition.h>
#include <osgRoads/core/query/RoadSurface.h>

#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

void expectNear(const glm::dvec3& found, const glm::dvec3& expected, double tolerance)
{
    EXPECT_NEAR(found.x, expected.x, tolerance);
    EXPECT_NEAR(found.y, expected.y, tolerance);
    EXPECT_NEAR(found.z, expected.z, tolerance);
}

Road only(const std::string& profiles, const std::string& lanes = twoLanes())
{
    RoadNetwork read = sound(network(road("1", 100.0, straightPlan(100.0) + profiles + lanes)));
    return read.roads.empty() ? Road() : read.roads.front();
}

TEST(RoadSurface, ElevationIsACubicOfS)
{
    const Road found =
        only(R"(<elevationProfile><elevation s="10" a="5" b="0.1" c="0.01" d="-0.001"/></elevationProfile>)");
    EXPECT_DOUBLE_EQ(surfacePoint(found, 5.0, 0.0).z, 0.0);
    expectNear(surfacePoint(found, 20.0, 2.0), {20.0, 2.0, 5.0 + 1.0 + 1.0 - 1.0}, 1e-12);
}

TEST(RoadSurface, SuperelevationTurnsAboutTheReferenceLine)
{
    const Road found =
        only(R"(<lateralProfile><superelevation s="0" a="0.1" b="0" c="0" d="0"/></lateralProfile>)");
    expectNear(surfacePoint(found, 30.0, 3.0), {30.0, 3.0 * std::cos(0.1), 3.0 * std::sin(0.1)}, 1e-12);
    expectNear(surfacePoint(found, 30.0, -3.0), {30.0, -3.0 * std::cos(0.1), -3.0 * std::sin(0.1)}, 1e-12);
    expectNear(surfaceNormal(found, 30.0, 1.0), {0.0, -std::sin(0.1), std::cos(0.1)}, 1e-9);
}

TEST(RoadSurface, FrameInvertsPoint)
{
    const Road found =
        only(R"(<elevationProfile><elevation s="0" a="2" b="0.05" c="0" d="0"/></elevationProfile>
<lateralProfile><superelevation s="0" a="0.1" b="0.01" c="0" d="0"/></lateralProfile>)");
    const RoadFrame frame = frameAt(found, 40.0);
    const glm::dvec2 across = frame.across(frame.pointAt(-2.5, 1.2));
    EXPECT_NEAR(across.x, -2.5, 1e-12);
    EXPECT_NEAR(across.y, 1.2, 1e-12);
}

/// Positive angles fall outwards on both sides: at t = ±3 by 3·tan 0.02.
TEST(RoadSurface, CrossfallFallsOutwards)
{
    const Road both =
        only(R"(<lateralProfile><crossfall side="both" s="0" a="0.02" b="0" c="0" d="0"/></lateralProfile>)");
    EXPECT_NEAR(surfaceHeight(both, 10.0, 3.0), -3.0 * std::tan(0.02), 1e-15);
    EXPECT_NEAR(surfaceHeight(both, 10.0, -3.0), -3.0 * std::tan(0.02), 1e-15);
    const Road left = only(
        R"(<lateralProfile><crossfall side="left" s="0" a="0.02" b="0.001" c="0" d="0"/></lateralProfile>)");
    EXPECT_NEAR(surfaceHeight(left, 10.0, 3.0), -3.0 * std::tan(0.03), 1e-15);
    EXPECT_DOUBLE_EQ(surfaceHeight(left, 10.0, -3.0), 0.0);
    expectNear(surfaceNormal(left, 10.0, -2.0), {0.0, 0.0, 1.0}, 1e-9);
}

/// Two cross-sections, at s 0 and 50: a roof 0.1 per metre from the left border at t = -3.5, and flat.
/// Half-way half.
TEST(RoadSurface, ShapeIsLinearBetweenItsSections)
{
    const Road found = only(R"(<lateralProfile><shape s="0" t="-3.5" a="0" b="0.1" c="0" d="0"/>
<shape s="0" t="0" a="0.35" b="-0.1" c="0" d="0"/><shape s="50" t="-3.5" a="0" b="0" c="0" d="0"/></lateralProfile>)");
    EXPECT_NEAR(surfaceHeight(found, 0.0, -2.5), 0.1, 1e-15);
    EXPECT_NEAR(surfaceHeight(found, 0.0, 2.0), 0.15, 1e-15);
    EXPECT_NEAR(surfaceHeight(found, 25.0, 2.0), 0.075, 1e-15);
    EXPECT_NEAR(surfaceHeight(found, 80.0, 2.0), 0.0, 1e-15);
}

TEST(RoadSurface, LaneHeightsAndLevelLanes)
{
    const std::string lanes =
        std::string(R"(<lanes><laneSection s="0"><left>
<lane id="2" type="sidewalk" level="true">)") +
        kWidth +
        R"(<height sOffset="0" inner="0.1" outer="0.2"/><height sOffset="50" inner="0.3" outer="0.2"/></lane>
<lane id="1" type="driving" level="false">)" +
        kWidth + R"(</lane></left>
<center><lane id="0" type="none" level="false"/></center></laneSection></lanes>)";
    const Road found =
        only(R"(<lateralProfile><superelevation s="0" a="0.1" b="0" c="0" d="0"/></lateralProfile>)", lanes);
    EXPECT_DOUBLE_EQ(surfaceHeight(found, 0.0, 2.0), 0.0);
    // The sidewalk begins at t = 3.5 and does not go on rising: its height above the sloping plane falls by
    // tan 0.1.
    const double outer = surfacePoint(found, 0.0, 6.9).z - surfacePoint(found, 0.0, 3.6).z;
    EXPECT_NEAR(outer, 0.1 * 3.3 / 3.5 * std::cos(0.1), 1e-12);
    // Half-way between the entries the inner border is at (0.1 + 0.3)/2, the outer at 0.2.
    EXPECT_NEAR(surfaceHeight(found, 25.0, 5.25) - (-std::tan(0.1) * 1.75), 0.2, 1e-12);
}

TEST(LaneSpan, WidthsOffsetsAndBorders)
{
    const std::string lanes = R"(<lanes><laneOffset s="0" a="0.5" b="0.01" c="0" d="0"/><laneSection s="0">
<left><lane id="1" type="driving" level="false"><border sOffset="0" a="3" b="0" c="0" d="0"/></lane>
<lane id="2" type="driving" level="false"><border sOffset="0" a="7" b="0" c="0" d="0"/></lane></left>
<center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false"><width sOffset="0" a="3" b="0.02" c="0" d="0"/>
<width sOffset="20" a="4" b="0" c="0" d="0"/></lane></right></laneSection></lanes>)";
    const Road found = only("", lanes);
    const std::optional<LaneSpan> left = laneSpan(found, 2, 10.0);
    ASSERT_TRUE(left);
    EXPECT_NEAR(left->innerT, 3.6, 1e-12); // border 3 and lane offset 0.6
    EXPECT_NEAR(left->outerT, 7.6, 1e-12);
    EXPECT_NEAR(laneSpan(found, -1, 10.0)->outerT, 0.6 - 3.2, 1e-12);
    EXPECT_NEAR(laneSpan(found, -1, 30.0)->outerT, 0.8 - 4.0, 1e-12);
    EXPECT_EQ(laneAt(found, 10.0, 5.0)->lane->id, 2);
    EXPECT_EQ(laneAt(found, 10.0, 0.0)->lane->id, -1);
    EXPECT_FALSE(laneAt(found, 10.0, -3.0));
    EXPECT_FALSE(laneAt(found, 10.0, 7.7));
    EXPECT_NEAR(extentAt(found, 10.0).rightT, -2.6, 1e-12);
    EXPECT_FALSE(laneSpan(found, 3, 10.0));
}

TEST(RoadPosition, PoseFollowsTheSlope)
{
    const RoadNetwork read = sound(
        network(road("1", 100.0,
                     straightPlan(100.0) +
                         R"(<elevationProfile><elevation s="0" a="0" b="0.1" c="0" d="0"/></elevationProfile>
<lateralProfile><superelevation s="0" a="0.05" b="0" c="0" d="0"/></lateralProfile>)" +
                         twoLanes())));
    const WorldPose pose = worldPose(read, {0, 10.0, -2.0, 0.0});
    expectNear(pose.position, {10.0, -2.0 * std::cos(0.05), 1.0 - 2.0 * std::sin(0.05)}, 1e-12);
    EXPECT_NEAR(pose.pitchRad, std::atan(0.1), 1e-8);
    // The plane rises by tan 0.05 to the left; seen along the slope, the roll is a little less.
    EXPECT_NEAR(pose.rollRad, std::atan(std::tan(0.05) * std::cos(std::atan(0.1))), 1e-8);
    EXPECT_NEAR(worldPose(read, {0, 10.0, 2.0, 0.0}, 3.14159265358979).pitchRad, -std::atan(0.1), 1e-8);
}

TEST(RoadSurface, BridgesAndTunnelsAreFoundByS)
{
    const Road found = only("", twoLanes() + R"(<objects>
<bridge id="b" name="Arch" s="20" length="15" type="concrete"/>
<tunnel id="t" name="Pipe" s="60" length="10" type="standard" lighting="0.5" daylight="0.1"/></objects>)");
    EXPECT_EQ(structureAt(found, 19.0), nullptr);
    ASSERT_NE(structureAt(found, 30.0), nullptr);
    EXPECT_EQ(structureAt(found, 30.0)->kind, StructureKind::bridge);
    EXPECT_EQ(structureAt(found, 65.0)->kind, StructureKind::tunnel);
    EXPECT_DOUBLE_EQ(structureAt(found, 65.0)->lighting, 0.5);
}

} // namespace
