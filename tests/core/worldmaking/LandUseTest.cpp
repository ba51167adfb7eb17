// SPDX-License-Identifier: Apache-2.0
// What is painted and planted of small made maps, and that nothing stands where it must not.
#include "worldmaking/land/LandUse.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <osgRoads/core/place/PlacedNetwork.h>

#include "MadeStreets.h"
#include "TestFolder.h"
#include "scenery/buildings/Outline.h"
#include "worldmaking/land/Trees.h"
#include "worldmaking/map/ReadLand.h"

namespace
{

using namespace worldmaking;
using testsupport::TestFolder;

/// A street through a wood with a lake, a house, an orchard, a hedge, a path and a stream.
MadeMap valley()
{
    MadeMap map;
    const auto box = [&](double eastM, double northM, double sideM, const char* key, const char* value)
    {
        const int first = map.node(eastM, northM);
        const int b = map.node(eastM + sideM, northM), c = map.node(eastM + sideM, northM + sideM),
                  d = map.node(eastM, northM + sideM);
        map.way({first, b, c, d, first}, {{key, value}});
    };
    map.way({map.node(-300, 0), map.node(300, 0)});
    box(-300, -300, 600, "landuse", "forest");
    box(100, 100, 80, "natural", "water");
    box(-100, 60, 15, "building", "house");
    box(-200, -200, 60, "landuse", "orchard");
    map.way({map.node(-90, 320), map.node(90, 320)}, {{"barrier", "hedge"}});
    map.way({map.node(-250, -250), map.node(250, -240)}, {{"highway", "path"}});
    map.way({map.node(-250, 250), map.node(250, 240)}, {{"waterway", "stream"}, {"width", "3"}});
    map.way({map.node(-250, 260), map.node(250, 250)}, {{"waterway", "stream"}, {"tunnel", "culvert"}});
    map.way({map.node(-250, 270), map.node(250, 260)}, {{"aerialway", "gondola"}});
    return map;
}

/// All that is made of it.
struct Made
{
    Streets streets;
    LandMap land;
    MapPlane plane;
    RoadRoom room;
    LandReport landReport;
    HouseReport houseReport;
    TreeReport treeReport;
    CoverRaster cover;
    std::vector<PlanRings> strips;
    std::vector<House> houses;
    std::vector<Tree> trees;

    explicit Made(const TestFolder& folder)
        : streets(streetsOf(valley(), [](double, double) { return 500.0; })),
          land(*readLand(folder.write("map.osm", valley().text()))),
          plane(*MapPlane::create(streets.network.header, "made")),
          room(streets.network),
          cover(coverRasterOf(land, plane, std::nullopt, landReport)),
          strips({{{{-300, -100}, {-200, -100}, {-200, 100}, {-300, 100}}}}),
          houses(housesOf(land, plane, {room, strips, [](const glm::dvec2&) { return true; }}, houseReport)),
          trees(treesOf(
              land, plane, {room, cover, houses, strips},
              [](const glm::dvec2&) { return std::optional(500.0); }, treeReport))
    {
    }
};

/// The trees that stand on a lane, in a house, in water, on a strip.
struct Wrong
{
    std::size_t onRoad = 0, inHouse = 0, inWater = 0, onStrip = 0;
};

Wrong wrongOf(const Made& made)
{
    Wrong wrong;
    for (const Tree& tree : made.trees)
    {
        wrong.onRoad += made.room.distanceM(tree.place, kTreeRoomM) < kTreeRoomM;
        wrong.inWater += made.cover.at(tree.place) == Cover::water;
        wrong.onStrip += scenery::isWithin(made.strips[0], tree.place);
        for (const House& house : made.houses)
            wrong.inHouse += scenery::isWithin(house.building.rings, tree.place);
    }
    return wrong;
}

TEST(LandUse, PaintsEachThingAndCountsTheOthers)
{
    const TestFolder folder("land");
    Made made(folder);
    const auto written = writeGround(made.land, {}, folder / "ground.gpkg", made.landReport);
    ASSERT_TRUE(written) << written.error().message();
    EXPECT_EQ(made.landReport.waters, 1u);
    EXPECT_EQ(made.landReport.waterLines, 1u) << "a stream in a culvert is not seen";
    EXPECT_EQ(made.landReport.ways, 1u);
    EXPECT_EQ(made.landReport.fields, 1u);
    EXPECT_EQ(made.landReport.unused.at("aerialway=gondola"), 1u);
    EXPECT_FALSE(made.landReport.unused.contains("barrier=hedge"));
    const auto read = readLand(folder / "ground.gpkg");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->shapes.size(), 4u);
}

TEST(LandUse, PaintsStepsAndStreetsThatAreClosedToCarsAsPaths)
{
    const TestFolder folder("land");
    MadeMap map;
    const auto add = [&](double northM, const std::vector<std::pair<const char*, const char*>>& tags) {
        map.way({map.node(-50, northM), map.node(50, northM)}, tags);
    };
    add(0, {{"highway", "steps"}});
    add(10, {{"highway", "footway"}});
    add(20, {{"highway", "service"}, {"motor_vehicle", "no"}});
    add(30, {{"highway", "service"}});
    add(40, {{"highway", "steps"}, {"bridge", "yes"}});
    LandReport report;
    const auto land = readLand(folder.write("paths.osm", map.text()));
    ASSERT_TRUE(land && writeGround(*land, {}, folder / "ground.gpkg", report));
    EXPECT_EQ(report.ways, 3u) << "neither the street nor what is on a bridge";
}

TEST(CoverRaster, SmallerAreasLieAboveLargerOnes)
{
    const TestFolder folder("land");
    const Made made(folder);
    const auto at = [&](double eastM, double northM)
    {
        const double metres = MadeMap::kMetresPerDegree;
        const auto plan =
            made.plane.toPlan({MadeMap::kLongitudeDeg + eastM / (metres * std::cos(0.741764932)),
                               MadeMap::kLatitudeDeg + northM / metres});
        return made.cover.at(*plan);
    };
    EXPECT_EQ(at(0, 200), Cover::trees);
    EXPECT_EQ(at(140, 140), Cover::water);
    EXPECT_EQ(at(-170, -170), Cover::grass);
    EXPECT_EQ(at(5000, 0), Cover::none);
    const auto written = made.cover.write(folder / "cover.tif", made.streets.network.header.geoReference);
    EXPECT_TRUE(written) << written.error().message();
    EXPECT_FALSE(made.cover.write(folder / "none/cover.tif", made.streets.network.header.geoReference));
}

TEST(Trees, FillTheWoodAndLeaveRoadsHousesWaterAndRunwaysFree)
{
    const TestFolder folder("land");
    Made made(folder);
    // 36 ha less lake, orchard, road and strip, a tree for each 121 m².
    EXPECT_GT(made.treeReport.inWoods, 2000u);
    EXPECT_LT(made.treeReport.inWoods, 2975u);
    EXPECT_NEAR(static_cast<double>(made.treeReport.inOrchards), 100.0, 15.0);
    EXPECT_GT(made.treeReport.hedges, 90u);
    const Wrong wrong = wrongOf(made);
    EXPECT_EQ(wrong.onRoad + wrong.inHouse + wrong.inWater + wrong.onStrip, 0u);
}

TEST(Trees, TheCountsSeeATreeThatIsMoved)
{
    const TestFolder folder("land");
    Made made(folder);
    Tree& tree = made.trees.front();
    ASSERT_EQ(made.houses.size(), 1u);
    tree.place = scenery::rectangleAround(made.houses[0].building.rings[0]).middle;
    EXPECT_EQ(wrongOf(made).inHouse, 1u);
    tree.place = glm::dvec2(
        osgRoads::core::PlacedNetwork(std::make_shared<osgRoads::core::RoadNetwork>(made.streets.network))
            .surfacePoint(0, 100.0, 0.0));
    EXPECT_EQ(wrongOf(made).onRoad, 1u);
    tree.place = glm::dvec2(-250, 0);
    EXPECT_EQ(wrongOf(made).onStrip, 1u);
}

TEST(Trees, AreTheSameEachTime)
{
    const TestFolder folder("land");
    const Made a(folder), b(folder);
    ASSERT_EQ(a.trees.size(), b.trees.size());
    for (std::size_t i = 0; i < a.trees.size(); ++i)
        EXPECT_EQ(a.trees[i].place, b.trees[i].place);
}

/// 4 ha of a settlement with a square and a path in it and a car that is parked.
TEST(Trees, GardensHaveSomeButNotOnSquaresAndPathsNorOverCars)
{
    const TestFolder folder("land");
    MadeMap map;
    const auto box = [&](double eastM, double northM, double sideM, const MadeMap::MapTags& tags)
    {
        const int first = map.node(eastM, northM);
        map.way({first, map.node(eastM + sideM, northM), map.node(eastM + sideM, northM + sideM),
                 map.node(eastM, northM + sideM), first},
                tags);
    };
    map.way({map.node(-150, -120), map.node(150, -120)});
    box(-100, -100, 200, {{"landuse", "residential"}});
    box(0, 0, 60, {{"highway", "pedestrian"}, {"area", "yes"}});
    map.way({map.node(-80, -90), map.node(-80, 90)}, {{"highway", "footway"}});
    map.node(-50, -50, {{"model", "saloon"}});
    const auto streets = streetsOf(map, [](double, double) { return 500.0; });
    const auto land = readLand(folder.write("map.osm", map.text()));
    ASSERT_TRUE(land);
    const auto plane = MapPlane::create(streets.network.header, "made");
    LandReport report;
    const CoverRaster cover = coverRasterOf(*land, *plane, std::nullopt, report);
    const double texelM2 = cover.texelM() * cover.texelM();
    EXPECT_NEAR(static_cast<double>(cover.count(Cover::garden)) * texelM2, 36400.0, 3500.0);
    EXPECT_NEAR(static_cast<double>(cover.count(Cover::yard)) * texelM2, 3600.0, 1300.0) << "the square";
    TreeReport trees;
    const RoadRoom room(streets.network);
    const auto planted = treesOf(
        *land, *plane, {room, cover, {}, {}}, [](const glm::dvec2&) { return std::optional(500.0); }, trees);
    EXPECT_EQ(trees.inGardens, planted.size());
    EXPECT_GT(trees.inGardens, 90U) << "0.8 of 160 squares of 15 m";
    EXPECT_LT(trees.inGardens, 150U);
    const double metres = MadeMap::kMetresPerDegree;
    std::size_t bushes = 0;
    for (const Tree& tree : planted)
    {
        const auto degrees = plane->toDegrees(tree.place);
        const glm::dvec2 at((degrees->x - MadeMap::kLongitudeDeg) * metres * std::cos(0.741764932),
                            (degrees->y - MadeMap::kLatitudeDeg) * metres);
        EXPECT_FALSE(at.x > 1.0 && at.x < 59.0 && at.y > 1.0 && at.y < 59.0) << "on the square";
        EXPECT_GT(glm::distance(at, glm::dvec2(-50, -50)), 8.5) << "over the car";
        EXPECT_GT(std::abs(at.x + 80.0), 1.8) << "on the path";
        bushes += tree.kind == "bush";
    }
    EXPECT_GT(bushes, 20U);
    EXPECT_LT(bushes, trees.inGardens - 20U);
}

TEST(Runways, OfOurAirportsHaveTwoEndsAndAWidth)
{
    const TestFolder folder("land");
    const std::string head =
        "id,airport_ident,width_ft,surface,closed,le_ident,le_latitude_deg,le_longitude_deg,"
        "he_ident,he_latitude_deg,he_longitude_deg\n";
    const auto table =
        readRunways(folder.write("runways.csv", head + "1,LESU,100,ASP,0,03,42.33,1.40,21,42.34,1.41\n"
                                                       "2,XXXX,100,ASP,1,03,42.33,1.40,21,42.34,1.41\n"
                                                       "3,YYYY,,GRVL,0,03,,,21,,\n"
                                                       "4,ZZZZ,,\"Turf, short\",0,09,42,1,27,42,1.01\n"));
    ASSERT_TRUE(table) << table.error().message();
    const std::vector<Runway>& runways = table->runways;
    ASSERT_EQ(runways.size(), 2u);
    EXPECT_EQ(table->unusable, 2u);
    EXPECT_TRUE(table->notes.empty()) << table->notes[0];
    EXPECT_NEAR(runways[0].widthM, 30.48, 1e-9);
    EXPECT_EQ(runways[0].designators, "03/21");
    EXPECT_EQ(runways[0].surface, "asphalt");
    EXPECT_EQ(runways[1].surface, "grass");
    folder.write("runways.csvt", "\"a\",\"b\",\"c\",\"d\",\"e\",\"f\",\"g\",\"h\",\"i\",\"j\",\"k\"\n");
    const auto warned = readRunways(folder / "runways.csv");
    ASSERT_TRUE(warned) << warned.error().message();
    ASSERT_FALSE(warned->notes.empty());
    EXPECT_NE(warned->notes[0].find("runways.csv: GDAL warns: Unknown type : a"), std::string::npos)
        << warned->notes[0];
    const auto lacking = readRunways(folder.write("other.csv", "a,b\n1,2\n"));
    ASSERT_FALSE(lacking);
    EXPECT_NE(lacking.error().message().find("has no column le_latitude_deg"), std::string::npos);
    EXPECT_FALSE(readRunways(folder / "none.csv"));
}

} // namespace
