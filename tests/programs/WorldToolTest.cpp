// SPDX-License-Identifier: Apache-2.0
// worldtool as somebody runs it: a country from real data, and what is told of bad input.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include <nlohmann/json.hpp>

#include <osgRoads/core/check/NetworkCheck.h>
#include <osgRoads/core/read/ReadNetwork.h>

#include "HillsText.h"
#include "MadeMap.h"
#include "ProgramRun.h"
#include "RealData.h"
#include "TestFolder.h"

namespace
{

using testsupport::TestFolder;

ProgramRun runWorldTool(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), OSGTRAINER_WORLDTOOL);
    return runProgram(arguments);
}

/// A flat raster of 0.02° around the made map's zero.
std::string writeGround(const TestFolder& folder)
{
    std::string text = "ncols 21\nnrows 21\nxllcorner 1.49\nyllcorner 42.49\ncellsize 0.001\n";
    for (int row = 0; row < 21; ++row)
    {
        for (int column = 0; column < 21; ++column)
            text += "500 ";
        text += '\n';
    }
    folder.write("flat.prj",
                 "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
                 "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]");
    return folder.write("flat.asc", text).string();
}

TEST(WorldTool, SaysWhatItCannotUse)
{
    const TestFolder folder("worldtool");
    const std::string ground = writeGround(folder), world = (folder / "world").string();
    MadeMap there, elsewhere;
    there.way({there.node(0, 0), there.node(200, 0)});
    elsewhere.way({elsewhere.node(90000, 0), elsewhere.node(90100, 0)});
    const auto built = [&](const std::string& dem, const std::filesystem::path& map) {
        return runWorldTool({"build", dem, "--map", map.string(), "-o", world});
    };
    EXPECT_TRUE(failsWith(built(ground, folder / "none.osm"), 1, "worldtool", {"none.osm", "no such file"}));
    EXPECT_TRUE(failsWith(built(ground, folder.write("empty.osm", "")), 1, "worldtool", {"is empty"}));
    EXPECT_TRUE(failsWith(built(ground, folder.write("cut.osm", there.text().substr(0, 150))), 1, "worldtool",
                          {"cut.osm: cannot be read as OpenStreetMap data"}));
    EXPECT_TRUE(
        failsWith(built(ground, folder.write("map.txt", "no")), 1, "worldtool", {"map.txt", ".osm.pbf"}));
    EXPECT_TRUE(failsWith(built(ground, folder.write("beside.osm", elsewhere.text())), 1, "worldtool",
                          {"beside.osm: none of its streets lies on the elevation data"}));
    EXPECT_TRUE(failsWith(built((folder / "no.tif").string(), folder.write("there.osm", there.text())), 1,
                          "worldtool", {"no.tif"}));
    EXPECT_FALSE(std::filesystem::exists(folder / "world/roads.xodr"));
    const ProgramRun whole = built(ground, folder / "there.osm");
    EXPECT_EQ(whole.exitCode, 0);
    EXPECT_NE(whole.output.find("streets: "), std::string::npos) << whole.text();
    EXPECT_NE(whole.output.find("all counts: "), std::string::npos);
    EXPECT_EQ(whole.output.find(": 0 "), std::string::npos) << "what is not there is not counted";
    EXPECT_LT(std::count(whole.output.begin(), whole.output.end(), '\n'), 20);
    EXPECT_TRUE(std::filesystem::exists(folder / "world/roads.xodr"));
    EXPECT_TRUE(std::filesystem::exists(folder / "world/world.roam"));
}

TEST(WorldTool, TheSameInputGivesTheSameBytes)
{
    const TestFolder folder("worldtool");
    const std::string ground = writeGround(folder);
    MadeMap map;
    const int middle = map.node(0, 0);
    for (const auto& [east, north] : {std::pair(200, 10), {-150, 60}, {20, -180}, {-30, 220}})
        map.way({middle, map.node(0.4 * east, 0.3 * north), map.node(east, north)});
    const int a = map.node(60, 80), b = map.node(75, 80), c = map.node(75, 92);
    map.way({a, b, c, a}, {{"building", "house"}});
    const std::string file = folder.write("map.osm", map.text()).string();
    for (const char* world : {"a", "b"})
        EXPECT_TRUE(
            succeeds(runWorldTool({"build", ground, "--map", file, "-o", (folder / world).string()})));
    EXPECT_EQ(testsupport::bytesOf(folder / "a/buildings.gpkg"),
              testsupport::bytesOf(folder / "b/buildings.gpkg"));
    EXPECT_FALSE(testsupport::bytesOf(folder / "a/buildings.gpkg").empty());
    EXPECT_NE(testsupport::bytesOf(folder / "a/world.roam").find("buildings = buildings.gpkg"),
              std::string::npos);
    EXPECT_EQ(testsupport::bytesOf(folder / "a/roads.xodr"), testsupport::bytesOf(folder / "b/roads.xodr"));
    EXPECT_FALSE(testsupport::bytesOf(folder / "a/roads.xodr").empty());
}

TEST(WorldTool, WhatItMakesStandsRightAndATreeOnTheStreetIsSeen)
{
    const TestFolder folder("worldtool");
    const std::string ground = writeGround(folder), world = (folder / "world").string();
    MadeMap map;
    map.way({map.node(-300, 0), map.node(300, 20)});
    for (const int northM : {3, 30, 34})
    {
        const int a = map.node(60, northM), b = map.node(75, northM), c = map.node(75, northM + 12);
        map.way({a, b, c, a}, {{"building", "house"}});
    }
    const int a = map.node(-300, -300), b = map.node(300, -300), c = map.node(300, 300),
              d = map.node(-300, 300);
    map.way({a, b, c, d, a}, {{"landuse", "forest"}});
    const std::string file = folder.write("map.osm", map.text()).string();
    ASSERT_TRUE(succeeds(runWorldTool({"build", ground, "--map", file, "-o", world})));
    const std::string table = (folder / "check.json").string();
    EXPECT_TRUE(succeeds(runWorldTool({"check", world, "--json", table})));
    const auto faults = nlohmann::json::parse(testsupport::bytesOf(table));
    EXPECT_GT(faults["objects"].get<int>(), 1000);
    EXPECT_EQ(faults["onRoad"].get<int>(), 0);
    std::ofstream(folder / "world/more.geojson")
        << R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"kind": "oak"},)"
        << R"( "geometry": {"type": "Point", "coordinates": [1.5, 42.50009]}}]})";
    std::ofstream(folder / "world/world.roam", std::ios::app) << "objects = more.geojson\n";
    EXPECT_EQ(runWorldTool({"check", world, "--json", table}).exitCode, 1);
    EXPECT_EQ(nlohmann::json::parse(testsupport::bytesOf(table))["onRoad"].get<int>(), 1);
    EXPECT_EQ(runWorldTool({"check", (folder / "none").string()}).exitCode, 1);
}

/// A map with something for every file of a world.
MadeMap mapOfEverything()
{
    MadeMap map;
    map.way({map.node(-300, 0), map.node(300, 20)});
    const auto box = [&](double eastM, double northM, double sideM, const char* key, const char* value)
    {
        const int a = map.node(eastM, northM), b = map.node(eastM + sideM, northM),
                  c = map.node(eastM + sideM, northM + sideM), d = map.node(eastM, northM + sideM);
        map.way({a, b, c, d, a}, {{key, value}});
    };
    box(60, 40, 12, "building", "house");
    box(-600, -700, 600, "landuse", "forest");
    box(300, 300, 120, "natural", "water");
    map.way({map.node(-500, 500), map.node(500, 520)}, {{"power", "line"}});
    map.way({map.node(-400, 700), map.node(400, 700)}, {{"aeroway", "runway"}, {"ref", "09/27"}});
    return map;
}

/// All files of a folder with their bytes.
std::map<std::string, std::string> filesOf(const std::filesystem::path& folder)
{
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files[entry.path().filename().string()] = testsupport::bytesOf(entry.path());
    return files;
}

TEST(WorldTool, ABuildThatWasKilledGoesOnToTheSameBytes)
{
    const TestFolder folder("worldtool");
    const std::string ground = writeGround(folder);
    const std::string file = folder.write("map.osm", mapOfEverything().text()).string();
    const auto command = [&](const char* world)
    {
        return std::vector<std::string>{OSGTRAINER_WORLDTOOL,     "build", ground, "--map", file, "-o",
                                        (folder / world).string()};
    };
    ASSERT_TRUE(succeeds(runProgram(command("whole"))));
    auto whole = filesOf(folder / "whole");
    for (const char* name :
         {"roads.xodr", "buildings.gpkg", "earthworks.gpkg", "structures.gpkg", "ground.gpkg",
          "landcover.tif", "trees.gpkg", "world.roam", "report.json", "build.json"})
        EXPECT_TRUE(whole.contains(name)) << name;
    int killed = 0;
    for (double limitS = 0.02; limitS < 3.0 && killed < 12; limitS *= 1.35)
    {
        const ProgramRun run = runProgram(command("killed"), limitS);
        if (!run.timedOut) break;
        ++killed;
        std::filesystem::create_directories(folder / "killed"); // it was killed before it made it
        std::filesystem::copy(folder / "killed", folder / "resumed",
                              std::filesystem::copy_options::recursive);
        EXPECT_TRUE(succeeds(runProgram(command("resumed"))));
        auto resumed = filesOf(folder / "resumed");
        for (const auto& [name, bytes] : whole)
            EXPECT_TRUE(resumed[name] == bytes) << name << " after " << limitS << " s";
        for (const auto& [name, bytes] : resumed)
            EXPECT_TRUE(whole.contains(name)) << name << " is left over";
        std::filesystem::remove_all(folder / "resumed");
    }
    EXPECT_GT(killed, 0) << "no build was killed";
}

TEST(WorldTool, AWorldThatIsMadeStaysAndADamagedFileIsMadeAgain)
{
    const TestFolder folder("worldtool");
    const std::string ground = writeGround(folder);
    const std::string file = folder.write("map.osm", mapOfEverything().text()).string();
    const auto build = [&] {
        return runWorldTool({"build", ground, "--map", file, "-o", (folder / "world").string()});
    };
    const ProgramRun first = build();
    ASSERT_TRUE(succeeds(first));
    const auto whole = filesOf(folder / "world");
    const auto madeAt = std::filesystem::last_write_time(folder / "world/trees.gpkg");
    const ProgramRun again = build();
    EXPECT_EQ(again.output, first.output);
    EXPECT_NE(again.errors.find("already"), std::string::npos);
    EXPECT_EQ(std::filesystem::last_write_time(folder / "world/trees.gpkg"), madeAt);
    std::ofstream(folder / "world/trees.gpkg", std::ios::app) << "x";
    EXPECT_EQ(build().errors.find("already"), std::string::npos);
    EXPECT_TRUE(filesOf(folder / "world") == whole);
    auto other = mapOfEverything();
    other.way({other.node(-300, -100), other.node(300, -100)});
    std::ofstream(file) << other.text();
    EXPECT_EQ(build().errors.find("already"), std::string::npos) << "another map";
    EXPECT_FALSE(filesOf(folder / "world") == whole);
}

TEST(WorldTool, AsManyProcessorsAsOneLikesGiveTheSameBytes)
{
    const TestFolder folder("worldtool");
    const std::string ground = writeGround(folder);
    const std::string file = folder.write("map.osm", mapOfEverything().text()).string();
    for (const char* jobs : {"1", "4"})
        ASSERT_TRUE(succeeds(
            runWorldTool({"build", ground, "--map", file, "--jobs", jobs, "-o", (folder / jobs).string()})));
    EXPECT_GT(filesOf(folder / "1").size(), 8u);
    EXPECT_TRUE(filesOf(folder / "1") == filesOf(folder / "4"));
}

/// A raster of one class over the ground of writeGround().
std::string writeCover(const TestFolder& folder, const std::string& name, const std::string& number)
{
    std::string text = "ncols 40\nnrows 40\nxllcorner 1.49\nyllcorner 42.49\ncellsize 0.0005\n";
    for (int row = 0; row < 40; ++row)
    {
        for (int column = 0; column < 40; ++column)
            text += number + ' ';
        text += '\n';
    }
    folder.write(name + ".prj", testsupport::bytesOf(folder / "flat.prj"));
    return folder.write(name + ".asc", text).string();
}

/// Where the map has a street and a lake, and nothing else.
TEST(WorldTool, ARasterOfLandCoverTellsWhatTheMapDoesNot)
{
    const TestFolder folder("worldtool");
    const std::string ground = writeGround(folder);
    MadeMap map;
    map.way({map.node(-400, -300), map.node(400, 300)});
    const int a = map.node(0, 200), b = map.node(30, 200), c = map.node(30, 230);
    map.way({a, b, c, a}, {{"natural", "water"}});
    const std::string file = folder.write("map.osm", map.text()).string();
    const auto treesWith = [&](const char* name, const char* number)
    {
        const std::string table = (folder / (std::string(name) + ".json")).string();
        EXPECT_TRUE(succeeds(
            runWorldTool({"build", ground, "--map", file, "--land-cover", writeCover(folder, name, number),
                          "-o", (folder / name).string(), "--json", table})));
        return nlohmann::json::parse(testsupport::bytesOf(table))["trees"]["inWoods"].get<int>();
    };
    EXPECT_GT(treesWith("trees", "10"), 1000); // WorldCover's classes
    EXPECT_EQ(treesWith("grass", "30"), 0);
}

/// The map of an editor, a change to it, and a map of another kind make one world; what is not taken as it
/// stands is told on a line each.
TEST(WorldTool, SeveralMapsOfSeveralKindsMakeOneWorld)
{
    const TestFolder folder("worldtool");
    const std::string ground = writeGround(folder), world = (folder / "world").string();
    const auto node = [](int id, double east, double north)
    {
        return "<node id='" + std::to_string(id) + "' lat='" + std::to_string(42.5 + north) + "' lon='" +
               std::to_string(1.5 + east) + "'/>";
    };
    const auto way = [](int id, int from, int to, const char* name, const char* more, const char* lanes)
    {
        return "<way id='" + std::to_string(id) + "' " + more + "><nd ref='" + std::to_string(from) +
               "'/><nd ref='" + std::to_string(to) +
               "'/><tag k='highway' v='residential'/><tag k='name' v='" + name + "'/><tag k='lanes' v='" +
               lanes + "'/></way>";
    };
    const auto josm = folder.write("josm.osm", "<osm version='0.6'>" + node(-1, 0, 0) + node(-2, 0.002, 0) +
                                                   node(5, 0, 0.002) + node(6, 0.002, 0.002) +
                                                   way(-3, -1, -2, "kept", "", "2;3") +
                                                   way(-4, -1, 5, "gone", "action='delete'", "2") +
                                                   way(7, 5, 6, "first", "", "many") + "</osm>");
    const auto change =
        folder.write("edit.osc", "<osmChange version='0.6'><modify>" + way(7, 5, 6, "changed", "", "2") +
                                     "</modify></osmChange>");
    const auto other = folder.write(
        "more.geojson",
        R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"building": "yes", "height":
 "tall", "name": "house"}, "geometry": {"type": "Polygon", "coordinates": [[[1.5, 42.501], [1.5002, 42.501], [1.5002,
 42.5011], [1.5, 42.5011], [1.5, 42.501]]]}}]})");
    // The raster stands last, behind the maps.
    const ProgramRun run = runWorldTool(
        {"build", "-o", world, "--map", josm.string(), other.string(), "--map", change.string(), ground});
    ASSERT_TRUE(succeeds(run));
    EXPECT_NE(run.errors.find("joined from 3 files"), std::string::npos) << run.errors;
    EXPECT_NE(run.errors.find("passed over: height=tall 1"), std::string::npos) << run.errors;
    EXPECT_NE(run.errors.find("approximated: lanes=2;3 1"), std::string::npos) << run.errors;
    const auto read = osgRoads::core::readNetwork((folder / "world/roads.xodr").string());
    ASSERT_TRUE(read);
    std::vector<std::string> names;
    for (const auto& road : read->network.roads)
        names.push_back(road.name);
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"changed", "kept"}));
    EXPECT_EQ(filesOf(folder / "world").count("map.part.osm.pbf"), 0u);
    EXPECT_EQ(
        nlohmann::json::parse(testsupport::bytesOf(folder / "world/report.json"))["buildings"]["standing"],
        1);
    EXPECT_TRUE(
        failsWith(runWorldTool({"build", "--map", josm.string(), "-o", world}), 2, "worldtool", {"DEM"}));
}

TEST(WorldTool, AMapWithoutStreetsMakesAWorldWithoutRoads)
{
    const TestFolder folder("worldtool");
    const std::string ground = writeGround(folder), world = (folder / "world").string();
    MadeMap map;
    const int a = map.node(60, 80), b = map.node(75, 80), c = map.node(75, 92);
    map.way({a, b, c, a}, {{"building", "house"}});
    EXPECT_TRUE(succeeds(
        runWorldTool({"build", ground, "--map", folder.write("map.osm", map.text()).string(), "-o", world})));
    EXPECT_TRUE(std::filesystem::exists(folder / "world/buildings.gpkg"));
    EXPECT_FALSE(std::filesystem::exists(folder / "world/roads.xodr"));
    EXPECT_TRUE(succeeds(runWorldTool({"check", world})));
}

/// The steepest grade of the roads for cars, and the worst tunnel: how far it lies above the straight line
/// between its ends.
struct Extremes
{
    double grade = 0.0, tunnelRiseM = 0.0;
};

Extremes extremesOf(const osgRoads::core::RoadNetwork& network)
{
    Extremes extremes;
    for (const auto& road : network.roads)
    {
        for (double s = 0.0; s <= road.length; s += 2.0)
            extremes.grade = std::max(extremes.grade, std::fabs(road.elevation.slope(s)));
        for (const auto& structure : road.structures)
        {
            if (structure.kind != osgRoads::core::StructureKind::tunnel) continue;
            const double start = road.elevation.value(structure.s);
            const double end = road.elevation.value(structure.s + structure.length);
            for (double s = 0.0; s <= structure.length; s += 10.0)
            {
                const double line = start + (end - start) * s / structure.length;
                extremes.tunnelRiseM =
                    std::max(extremes.tunnelRiseM, road.elevation.value(structure.s + s) - line);
            }
        }
    }
    return extremes;
}

/// A plain with hills in the north, 7 km wide.
std::string writeHills(const TestFolder& folder)
{
    folder.write("hills.prj", testsupport::bytesOf(folder / "flat.prj"));
    return folder.write("hills.asc", hillsText()).string();
}

TEST(WorldTool, WithoutAMapItMakesOneUpThatStandsRight)
{
    const TestFolder folder("worldtool");
    (void)writeGround(folder);
    const std::string hills = writeHills(folder);
    const auto built = [&](const char* world, const char* seed) {
        return runWorldTool({"build", hills, "--seed", seed, "-o", (folder / world).string()});
    };
    ASSERT_TRUE(succeeds(built("a", "1")));
    ASSERT_TRUE(succeeds(built("b", "1")));
    ASSERT_TRUE(succeeds(built("c", "2")));
    for (const char* file :
         {"roads.xodr", "buildings.gpkg", "ground.gpkg", "trees.gpkg", "objects.gpkg", "drive.xosc"})
    {
        const std::string a = testsupport::bytesOf(folder / "a" / file);
        EXPECT_FALSE(a.empty()) << file;
        EXPECT_EQ(a, testsupport::bytesOf(folder / "b" / file)) << file;
        EXPECT_NE(a, testsupport::bytesOf(folder / "c" / file)) << file;
    }
    const std::string report = (folder / "report.json").string();
    EXPECT_TRUE(succeeds(runWorldTool({"check", (folder / "a").string(), "--json", report})));
    const auto found = nlohmann::json::parse(testsupport::bytesOf(report));
    EXPECT_GT(found["objects"].get<int>(), 500);
    EXPECT_GT(found["roadsKm"].get<double>(), 2.0);
    EXPECT_TRUE(failsWith(runWorldTool({"build", hills, "--map", "x.osm", "--seed", "2", "-o", "y"}), 2,
                          "worldtool", {"--seed"}));
}

TEST(WorldTool, ACountryOfRealStreetsHasNoOpenJointAndNoSteepRoad)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(map, "osm/andorra.osm.pbf");
    OSGTRAINER_REAL_DATA_OR_SKIP(dem, "dem/N42E001.hgt.zip");
    const TestFolder folder("worldtool");
    const std::string table = (folder / "report.json").string();
    ASSERT_TRUE(succeeds(runWorldTool(
        {"build", dem.string(), "--map", map.string(), "-o", (folder / "world").string(), "--json", table})));
    const auto report = nlohmann::json::parse(testsupport::bytesOf(table))["streets"];
    EXPECT_EQ(report["waysBeyondGround"], 0);
    EXPECT_GT(report["roadsKm"], 400.0);
    const auto read = osgRoads::core::readNetwork((folder / "world/roads.xodr").string());
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_TRUE(read->problems.empty());
    osgRoads::core::JointLimits limits; // 1 cm in the plan
    limits.laneStepM = 0.01;
    const auto joints = osgRoads::core::checkLaneJoints(read->network, limits);
    EXPECT_GT(joints.count, 20000u);
    EXPECT_TRUE(joints.flaws.empty()) << joints.flaws.front().message("roads.xodr");
    EXPECT_TRUE(osgRoads::core::checkElementJoints(read->network).empty());
    const Extremes extremes = extremesOf(read->network);
    EXPECT_LE(extremes.grade, 0.155); // 0.15, and what the plane of a crossing adds to an arm across it
    EXPECT_LE(extremes.tunnelRiseM, 10.0) << "a tunnel climbs over its hill";
}

TEST(WorldTool, BoundsWithLatitudeFirstAreToldAndNoFolderIsLeft)
{
    const TestFolder folder("worldtool-bounds");
    const std::string ground = writeGround(folder), world = (folder / "world").string();
    const auto built = [&](const std::string& bounds) {
        return runWorldTool({"build", ground, "--bounds", bounds, "-o", world});
    };
    EXPECT_TRUE(
        failsWith(built("42.492,1.492,42.508,1.508"), 1, "worldtool",
                  {"--bounds", "lies beside the elevation data", "did you mean 1.492,42.492,1.508,42.508?"}));
    EXPECT_TRUE(failsWith(built("8,46,9,47"), 1, "worldtool", {"--bounds", "within it"}));
    EXPECT_FALSE(std::filesystem::exists(world));
    EXPECT_TRUE(failsWith(runWorldTool({"build", folder.write("map.osm.pbf", "x").string(), "-o", world}), 1,
                          "worldtool", {"is a map of OpenStreetMap", "--map FILE"}));
    EXPECT_FALSE(std::filesystem::exists(world));
}

} // namespace
