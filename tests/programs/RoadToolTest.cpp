// SPDX-License-Identifier: Apache-2.0
// roadtool as somebody runs it, and its images.
#include <algorithm>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include <osgRoads/core/read/ReadNetwork.h>

#include "ProgramRun.h"
#include "RoadTexts.h"
#include "Workplace.h"
#include "roadtool/Pictures.h"

namespace
{

using nlohmann::ordered_json;
using Words = std::vector<std::string>;

std::string bytesOf(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

ProgramRun runRoadTool(Words arguments)
{
    arguments.insert(arguments.begin(), OSGTRAINER_ROADTOOL);
    return runProgram(arguments);
}

/// A sound road of 50 m, and one with a gap of half a metre.
std::string soundRoad(const Workplace& place)
{
    using namespace roadtexts;
    return place.write("sound.xodr", network(road("1", 50.0, straightPlan(50.0) + twoLanes())));
}

std::string brokenRoad(const Workplace& place)
{
    using namespace roadtexts;
    const std::string plan = "<planView>" + geometry(R"(s="0" x="0" y="0" hdg="0")", 25.0, "<line/>") +
                             geometry(R"(s="25" x="25" y="0.5" hdg="0")", 25.0, "<line/>") + "</planView>\n";
    return place.write("gap.xodr", network(road("1", 50.0, plan + twoLanes() + "<railroad/>")));
}

TEST(RoadTool, ValidateTellsGapsAndFailsOnWhatCannotBeUsed)
{
    const Workplace place;
    const std::string table = place.path("table.json");
    ProgramRun run = runRoadTool({"validate", soundRoad(place), brokenRoad(place), "--json", table});
    EXPECT_TRUE(succeeds(run));
    ordered_json rows = ordered_json::parse(bytesOf(table))["files"];
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["gaps"], 0);
    EXPECT_EQ(rows[0]["lengthM"], 50.0);
    EXPECT_EQ(rows[1]["gaps"], 1);
    EXPECT_EQ(rows[1]["unsupported"], 1);
    EXPECT_NE(
        run.output.find("gap.xodr:3: road 1 at s 25: the geometry has a gap of 0.5 m; let the elements meet"),
        std::string::npos)
        << run.output;
    run = runRoadTool(
        {"validate", place.write("none.xodr", "<OpenDRIVE/>"), soundRoad(place), "--json", table});
    EXPECT_EQ(run.exitCode, 1);
    rows = ordered_json::parse(bytesOf(table))["files"];
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_TRUE(rows[0].contains("error"));
    EXPECT_EQ(rows[1]["roads"], 1);
}

TEST(RoadTool, InfoCounts)
{
    const Workplace place;
    const std::string table = place.path("table.json");
    EXPECT_TRUE(succeeds(runRoadTool({"info", brokenRoad(place), "--json", table})));
    const ordered_json row = ordered_json::parse(bytesOf(table))["files"][0];
    EXPECT_EQ(row["version"], "1.7");
    EXPECT_EQ(row["geometry"]["line"], 2);
    EXPECT_EQ(row["carLaneLengthM"], 100.0);
    EXPECT_EQ(row["unsupported"][0]["what"], "road/railroad is not supported");
    EXPECT_TRUE(
        failsWith(runRoadTool({"info", place.path("missing.xodr")}), 1, "roadtool", {"no such file"}));
}

TEST(RoadTool, DrawsSvgAndPng)
{
    const Workplace place;
    const std::string svg = place.path("a.svg"), png = place.path("a.png");
    EXPECT_TRUE(
        succeeds(runRoadTool({"draw", soundRoad(place), "--svg", svg, "--png", png, "--pixels", "200"})));
    EXPECT_EQ(bytesOf(svg).substr(0, 4), "<svg");
    EXPECT_EQ(bytesOf(png).substr(1, 3), "PNG");
    const Words files = place.files();
    EXPECT_EQ(std::count_if(files.begin(), files.end(),
                            [](const std::string& file) { return file.find("a.png") != std::string::npos; }),
              1); // no file of GDAL's beside it
    EXPECT_TRUE(failsWith(runRoadTool({"draw", soundRoad(place)}), 1, "roadtool", {"--svg"}));
    EXPECT_TRUE(failsWith(runRoadTool({"draw", soundRoad(place), "--png", "/nowhere/a.png"}), 1, "roadtool",
                          {"/nowhere/a.png"}));
}

/// A square of 4 m in a view of 8 m: 8 pixels, of which the middle 4 are covered; half-covered ones are half
/// as dark.
TEST(RoadTool, PaintsTheShareOfEachPixelThatIsCovered)
{
    using namespace roadtool;
    TopView view;
    view.background = {200, 200, 200};
    view.bounds.include({0.0, 0.0});
    view.bounds.include({8.0, 8.0});
    view.polygons.push_back({{{2.5, 2.0}, {6.0, 2.0}, {6.0, 6.0}, {2.5, 6.0}}, {0, 100, 0}});
    const RgbImage image = paintedImage(view, 8);
    ASSERT_EQ(image.width, 8);
    const auto red = [&](int x, int y)
    { return static_cast<int>(image.pixels[3 * static_cast<std::size_t>(y * 8 + x)]); };
    EXPECT_EQ(red(1, 4), 200);
    EXPECT_EQ(red(2, 4), 100);
    EXPECT_EQ(red(3, 4), 0);
    EXPECT_EQ(red(6, 4), 200);
    EXPECT_EQ(red(4, 1), 200);
}

/// Lanes are as wide in the image as on the road, north is up, and left lanes lie to the north of a road to
/// the east.
TEST(RoadTool, TheTopViewShowsLanesInPlace)
{
    using namespace roadtexts;
    std::string text = network(road("1", 50.0, straightPlan(50.0) + twoLanes()));
    text.replace(text.find("type=\"driving\""), 14, "type=\"sidewalk\"");
    const osgRoads::core::RoadNetwork read = sound(text);
    const roadtool::TopView view = roadtool::topView(read);
    ASSERT_EQ(view.polygons.size(), 2u);
    const auto& right = view.polygons[0].corners; // right lanes first
    const auto [low, high] =
        std::minmax_element(right.begin(), right.end(), [](glm::dvec2 a, glm::dvec2 b) { return a.y < b.y; });
    EXPECT_DOUBLE_EQ(low->y, -3.5);
    EXPECT_DOUBLE_EQ(high->y, 0.0);
    const roadtool::RgbImage image = roadtool::paintedImage(view, 520);
    const auto greyAt = [&](double east, double north)
    {
        const double scale = 520.0 / (view.bounds.most.x - view.bounds.least.x);
        const auto x = static_cast<std::size_t>((east - view.bounds.least.x) * scale);
        const auto y = static_cast<std::size_t>((view.bounds.most.y - north) * scale);
        return static_cast<int>(image.pixels[3 * (y * static_cast<std::size_t>(image.width) + x)]);
    };
    EXPECT_EQ(greyAt(25.0, -1.75), 88);
    EXPECT_EQ(greyAt(25.0, 1.75), 188);
}

TEST(RoadTool, APictureInAnotherFormatThanItsNameIsRefused)
{
    const Workplace place;
    const std::string road = soundRoad(place);
    EXPECT_TRUE(failsWith(runRoadTool({"draw", road, "--png", place.path("x.svg")}), 2, "roadtool",
                          {"--png", "x.svg", "does not end in .png"}));
    EXPECT_TRUE(failsWith(runRoadTool({"draw", road, "--svg", place.path("x.png")}), 2, "roadtool",
                          {"--svg", "x.png", "does not end in .svg"}));
    EXPECT_FALSE(std::filesystem::exists(place.path("x.svg")));
}

} // namespace
