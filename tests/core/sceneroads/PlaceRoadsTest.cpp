// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/PlaceRoads.h"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "RealData.h"
#include "SyntheticField.h"
#include "scenery/roads/CutRoads.h"
#include "scenery/roads/PlanMap.h"
#include "scenery/roads/RoadGround.h"

namespace
{

using namespace osgTerrainROAM::core;
using scenery::PlanMap;

/// A tangent plane's sag and a turn of 30°: what a projection does to a plan of 40 km.
foundation::Result<glm::dvec3> bent(const glm::dvec2& plan, double heightM)
{
    const glm::dvec2 from = plan - glm::dvec2(1e7, -3e6);
    const glm::dvec3 up = glm::normalize(glm::dvec3(from / 6.37e6, 1.0));
    const glm::dvec3 foot(0.8 * from.x - 0.6 * from.y, 0.6 * from.x + 0.8 * from.y,
                          -glm::dot(from, from) / (2.0 * 6.37e6));
    return foot + heightM * glm::dvec3(0.8 * up.x - 0.6 * up.y, 0.6 * up.x + 0.8 * up.y, up.z);
}

const glm::dvec2 kLow(1e7 - 2e4, -3e6 - 2e4), kHigh(1e7 + 2e4, -3e6 + 2e4);

/// Writes a straight road through (0, 0) of the file.
std::filesystem::path straightFile(const std::string& header)
{
    const auto file = std::filesystem::path(testing::TempDir()) / "straight.xodr";
    std::ofstream(file) << R"(<OpenDRIVE><header revMajor="1" revMinor="7">)" << header
                        << R"(</header><road id="1" length="400" junction="-1">
<planView><geometry s="0" x="-200" y="0" hdg="0" length="400"><line/></geometry></planView>
<elevationProfile><elevation s="0" a="2" b="0" c="0" d="0"/></elevationProfile>
<lanes><laneSection s="0"><center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right>
</laneSection></lanes></road></OpenDRIVE>)";
    return file;
}

PlacedTile tileInTheAlps()
{
    return PlacedTile(testsupport::onTheEarth(testsupport::hills(65, 65)), Placement::curved);
}

} // namespace

TEST(PlanMap, IsThePlaceWithinAMicrometreAndBack)
{
    const auto map = PlanMap::create(kLow, kHigh, bent);
    ASSERT_TRUE(map);
    for (double x = 0.013; x < 1.0; x += 0.0917)
        for (double y = 0.027; y < 1.0; y += 0.1013)
        {
            const glm::dvec3 plan(glm::mix(kLow, kHigh, glm::dvec2(x, y)), 1234.5);
            const glm::dvec3 scene = map->toScene(plan);
            EXPECT_LT(glm::distance(scene, *bent(plan, plan.z)), 1e-6);
            EXPECT_LT(glm::distance(map->toPlan(scene), plan), 1e-7);
        }
}

TEST(PlaceRoads, AStatedOriginPutsTheFilesZeroThere)
{
    const PlacedTile tile = tileInTheAlps();
    const auto middle = tile.frame().geodeticFromLocal(tile.position(32, 32));
    const auto roads = scenery::placeRoads(
        {straightFile(""), scenery::RoadOrigin{middle.latitudeDeg, middle.longitudeDeg, 90.0},
         scenery::RoadHeights::ground},
        tile);
    ASSERT_TRUE(roads) << roads.error().message();
    const glm::dvec3 zero = roads->placed->surfacePoint(0, 200.0, 0.0);
    EXPECT_LT(glm::distance(glm::dvec2(zero), glm::dvec2(tile.position(32, 32))), 0.2);
    // With its y axis to the east the road runs south.
    const glm::dvec3 way = roads->placed->surfacePoint(0, 210.0, 0.0) - zero;
    EXPECT_NEAR(way.y, -10.0, 0.01);
    EXPECT_NEAR(glm::length(glm::dvec2(way)), 10.0, 1e-3);
    const auto back = roads->placed->toInertial(zero);
    EXPECT_NEAR(back.x, 0.0, 1e-6);
    EXPECT_NEAR(back.y, 0.0, 1e-6);
    EXPECT_NEAR(back.z, 2.0, 1e-6);
}

TEST(PlaceRoads, AFileWithoutAGeoreferenceNeedsAnOrigin)
{
    const auto roads =
        scenery::placeRoads({straightFile(""), std::nullopt, scenery::RoadHeights::file}, tileInTheAlps());
    ASSERT_FALSE(roads);
    EXPECT_NE(roads.error().message().find("roads_origin = LAT LON"), std::string::npos)
        << roads.error().message();
}

TEST(RoadGround, LiesUnderTheRoadsOfARealNetwork)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "openscenario/esmini/xodr/e6mini.xodr");
    auto ground = scenery::makeRoadGround(file);
    ASSERT_TRUE(ground) << ground.error().message();
    const auto tile = std::make_shared<RoamTile>(PlacedTile(
        std::move(ground->field), PlacedTileOptions{.placement = Placement::planar, .gridExponent = 2}));
    TileEditor editor(tile);
    ASSERT_TRUE(scenery::cutRoads(editor, *ground->roads.placed));
    const auto& placed = *ground->roads.placed;
    for (int road = 0; road < static_cast<int>(placed.network().roads.size()); ++road)
        for (double s = 5.0; s < placed.road(road).length - 5.0; s += 11.0)
        {
            const glm::dvec3 place = placed.surfacePoint(road, s, -1.0);
            const double depthM = place.z - groundAt(tile->tile, place.x, place.y)->position.z;
            EXPECT_GT(depthM, 0.2) << road << " " << s;
            EXPECT_LT(depthM, 0.8) << road << " " << s;
        }
}
