// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/Structures.h"

#include <gtest/gtest.h>

#include "MadeMap.h"
#include "MadeStreets.h"
#include "TestFolder.h"
#include "worldmaking/map/ReadLand.h"

namespace
{

MadeMap valleyWithWalls()
{
    MadeMap map;
    map.way({map.node(-300, 0), map.node(300, 0)});
    map.way({map.node(0, -60), map.node(0, 60)}, {{"barrier", "wall"}});
    map.way({map.node(100, 20), map.node(200, 20)}, {{"barrier", "fence"}});
    map.way({map.node(-250, 270), map.node(250, 260)}, {{"power", "line"}});
    map.way({map.node(-250, 280), map.node(250, 290)}, {{"railway", "rail"}});
    map.way({map.node(-250, 300), map.node(250, 300)}, {{"power", "line"}, {"location", "underground"}});
    return map;
}

} // namespace

TEST(WorldStructures, WallsEndAtRoadsAndRunwaysGetWindsocks)
{
    const testsupport::TestFolder folder("structures");
    const auto streets = streetsOf(valleyWithWalls(), [](double, double) { return 500.0; });
    const auto land = worldmaking::readLand(folder.write("map.osm", valleyWithWalls().text()));
    ASSERT_TRUE(land);
    const auto plane = worldmaking::MapPlane::create(streets.network.header, "made");
    ASSERT_TRUE(plane);
    const worldmaking::RoadRoom room(streets.network);
    worldmaking::Runway runway;
    runway.from = *plane->toDegrees(glm::dvec2(-250.0, -200.0));
    runway.to = *plane->toDegrees(glm::dvec2(250.0, -200.0));
    const std::vector<worldmaking::Runway> runways{runway};
    const std::vector<worldmaking::PlanRings> strips{*worldmaking::stripOf(runway, *plane)};
    worldmaking::StructureReport report;
    const auto ground = [](const glm::dvec2&) { return std::optional(500.0); };
    const auto written = worldmaking::writeStructures(*land, *plane, {room, runways, strips, ground},
                                                      folder / "structures.gpkg", report);
    ASSERT_TRUE(written) << written.error().message();
    EXPECT_EQ(report.walls, 1u);
    EXPECT_EQ(report.fences, 1u);
    EXPECT_EQ(report.powerLines, 1u) << "a cable is not seen";
    EXPECT_EQ(report.railways, 1u);
    EXPECT_EQ(report.windsocks, 1u);
    EXPECT_EQ(report.cut, 1u);
    const auto read = worldmaking::readLand(folder / "structures.gpkg");
    ASSERT_TRUE(read) << read.error().message();
    std::size_t walls = 0;
    for (const auto& shape : read->shapes)
    {
        const auto path = plane->toPlan(shape.paths.front().front());
        if (worldmaking::valueOf(shape.tags, "barrier") == "wall")
        {
            ++walls;
            for (const glm::dvec2& degrees : shape.paths.front())
                EXPECT_GE(room.distanceM(*plane->toPlan(degrees), 5.0), worldmaking::kGateM);
        }
        if (worldmaking::valueOf(shape.tags, "kind") == "windsock")
        {
            EXPECT_GT(std::abs(path->y + 200.0), 0.5 * runway.widthM + worldmaking::kStripSideM);
        }
    }
    EXPECT_EQ(walls, 2u) << "one piece on either side of the street";
    EXPECT_LT(room.distanceM({0.0, 0.0}, 5.0), worldmaking::kGateM) << "uncut it would stand on the street";
}

TEST(WorldStructures, TellLampsAndWhichStreetsAreLit)
{
    const testsupport::TestFolder folder("lamps");
    MadeMap map;
    map.way({map.node(-300, 0), map.node(300, 0)}, {{"highway", "residential"}, {"lit", "yes"}});
    map.way({map.node(-300, 80), map.node(300, 80)}, {{"highway", "residential"}, {"lit", "no"}});
    map.way({map.node(-300, 160), map.node(300, 160)}, {{"highway", "residential"}});
    map.way({map.node(-300, 240), map.node(300, 240)},
            {{"highway", "residential"}, {"lit", "yes"}, {"tunnel", "yes"}});
    map.node(20, 5, {{"highway", "street_lamp"}});
    const auto streets = streetsOf(map, [](double, double) { return 500.0; });
    const auto land = worldmaking::readLand(folder.write("map.osm", map.text()));
    ASSERT_TRUE(land);
    const auto plane = worldmaking::MapPlane::create(streets.network.header, "made");
    ASSERT_TRUE(plane);
    worldmaking::StructureReport report;
    const auto ground = [](const glm::dvec2&) { return std::optional(500.0); };
    const worldmaking::RoadRoom room(streets.network);
    ASSERT_TRUE(worldmaking::writeStructures(*land, *plane, {room, {}, {}, ground},
                                             folder / "structures.gpkg", report));
    EXPECT_EQ(report.streetLamps, 1u);
    EXPECT_EQ(report.litStreets, 1u) << "the tunnel's lamps are its own";
    EXPECT_EQ(report.unlitStreets, 1u);
    const auto read = worldmaking::readLand(folder / "structures.gpkg");
    ASSERT_TRUE(read) << read.error().message();
    std::size_t lit = 0, unlit = 0, lamps = 0;
    for (const auto& shape : read->shapes)
    {
        lit += worldmaking::valueOf(shape.tags, "lit") == "yes";
        unlit += worldmaking::valueOf(shape.tags, "lit") == "no";
        lamps += worldmaking::valueOf(shape.tags, "kind") == "street_lamp";
    }
    EXPECT_EQ(lit, 1u);
    EXPECT_EQ(unlit, 1u);
    EXPECT_EQ(lamps, 1u);
}
