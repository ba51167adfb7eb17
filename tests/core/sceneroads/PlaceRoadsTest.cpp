// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/PlaceRoads.h"

#include <cmath>
#include <fstream>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/TransverseMercator.hpp>
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
    EXPECT_NEAR(back.z, 2.0, 0.5) << "above the smoothed ground, in which the road is cut";
}

constexpr double kBesselA = 6377397.155, kBesselF = 1.0 / 299.1528128;

/// Latitude and longitude on Bessel's ellipsoid.
glm::dvec2 besselDegrees(double eastM, double northM)
{
    const GeographicLib::TransverseMercator projection(kBesselA, kBesselF, 1.0);
    double latitude = 0.0, longitude = 0.0;
    projection.Reverse(9.0, eastM - 3'500'000.0, northM, latitude, longitude);
    return {latitude, longitude};
}

/// Where a plan position of the German grid (Gauss and Krüger's zone 3 on Bessel's ellipsoid, DHDN) lies on
/// WGS84: worked out without PROJ, by Helmert's seven parameters in the coordinate frame of the Earth
/// (position vector convention).
glm::dvec2 degreesOfGermanGrid(double eastM, double northM)
{
    using namespace GeographicLib;
    const glm::dvec2 bessel = besselDegrees(eastM, northM);
    glm::dvec3 x(0.0);
    Geocentric(kBesselA, kBesselF).Forward(bessel.x, bessel.y, 0.0, x.x, x.y, x.z);
    const glm::dvec3 turn = glm::dvec3(0.202, 0.045, -2.455) * (std::acos(-1.0) / 648000.0);
    x = glm::dvec3(598.1, 73.7, 418.2) + (1.0 + 6.7e-6) * (x + glm::cross(turn, x));
    double latitude = 0.0, longitude = 0.0, height = 0.0;
    Geocentric::WGS84().Reverse(x.x, x.y, x.z, latitude, longitude, height);
    return {latitude, longitude};
}

/// The file's zero and the ground of the tile at a place in the Alps, by a georeference with another datum.
TEST(PlaceRoads, AGeoreferencePutsTheFileThroughItsDatumAndOffset)
{
    const PlacedTile tile = tileInTheAlps();
    const double eastM = 3'424'700.0, northM = 5'099'350.0;
    const std::string header =
        "<geoReference>+proj=tmerc +lat_0=0 +lon_0=9 +k=1 +x_0=3500000 +ellps=bessel "
        "+towgs84=598.1,73.7,418.2,0.202,0.045,-2.455,6.7 +units=m</geoReference><offset x=\"" +
        std::to_string(eastM) + "\" y=\"" + std::to_string(northM) + "\" z=\"300\" hdg=\"0\"/>";
    const auto roads =
        scenery::placeRoads({straightFile(header), std::nullopt, scenery::RoadHeights::file}, tile);
    ASSERT_TRUE(roads) << roads.error().message();
    for (const double s : {0.0, 200.0, 390.0}) // the file's x from -200 to 190
    {
        const glm::dvec2 expected = degreesOfGermanGrid(eastM + s - 200.0, northM);
        const glm::dvec3 place = roads->placed->surfacePoint(0, s, 0.0);
        const auto geodetic = tile.frame().geodeticFromLocal(place);
        EXPECT_NEAR(geodetic.latitudeDeg, expected.x, 1e-7) << "more than 1 cm off";
        EXPECT_NEAR(geodetic.longitudeDeg, expected.y, 1e-7);
        EXPECT_NEAR(tile.frame().heightOf(place), 302.0, 1e-3) << "elevation 2 m above the offset's 300 m";
        EXPECT_NEAR(roads->placed->toInertial(place).x, s - 200.0, 1e-6);
    }
    // Without the datum it would be about 100 m away.
    const glm::dvec2 wrong = besselDegrees(eastM, northM);
    const glm::dvec3 there = tile.frame().localFromGeodetic({wrong.x, wrong.y, 302.0});
    EXPECT_GT(glm::distance(glm::dvec2(there), glm::dvec2(roads->placed->surfacePoint(0, 200.0, 0.0))), 80.0);
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
