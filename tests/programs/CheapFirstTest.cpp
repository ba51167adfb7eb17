// SPDX-License-Identifier: Apache-2.0
// Wrong calls are answered before any work: what takes long to read is not opened. Opened files are counted
// instead of seconds.
#include "OpenedFiles.h"
#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

/// A call in which one thing is wrong, besides which everything is there.
struct WrongCall
{
    const char* name;
    std::vector<std::string> command;  ///< HERE stands for the workplace
    std::vector<std::string> words;    ///< of the one line that it prints
    std::vector<std::string> unopened; ///< files that would be read if the work began
};

/// A workplace with all that the calls name: dem.tif, model.obj, roads.xodr, map.osm, the folders `folder`
/// and `folder.png`, the text notes.txt.
class CheapFirst : public testing::Test
{
protected:
    CheapFirst()
    {
        std::filesystem::rename(_place.hill(), _place.path("dem.tif"));
        (void)_place.write("model.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
        (void)_place.write("roads.xodr", readBytes(OSGTRAINER_SOURCE_DIR "/data/street.xodr"));
        (void)_place.write("map.osm",
                           "<osm version=\"0.6\"><node id=\"1\" lat=\"46.01\" lon=\"8.01\"/></osm>");
        (void)_place.write("notes.txt", "heights to come\n");
        (void)_place.write("points.csv", "0,0,1\n10,0,2\n0,10,3\n");
        std::filesystem::create_directory(_place.path("folder"));
        std::filesystem::create_directory(_place.path("folder.png"));
    }

    ProgramRun run(std::vector<std::string> command) const
    {
        for (std::string& word : command)
            if (const std::size_t at = word.find("HERE"); at != std::string::npos)
                word.replace(at, 4, _place.path(""));
        return runProgram(command);
    }

    const Workplace _place;
};

class WrongCalls : public CheapFirst, public testing::WithParamInterface<WrongCall>
{
};

TEST_P(WrongCalls, OpenNothingThatTakesLong)
{
    const auto before = _place.files();
    OpenedFiles files(_place.path(""));
    const std::string program = std::filesystem::path(GetParam().command.front()).filename();
    EXPECT_TRUE(failsWith(run(GetParam().command), 1, program, GetParam().words));
    const auto opened = files.take();
    for (const std::string& file : GetParam().unopened)
        EXPECT_FALSE(opened.contains(file)) << file;
    EXPECT_EQ(_place.files(), before); // nor is a folder for a world made
}

const std::string kTrainer = OSGTRAINER_TRAINER, kWorldTool = OSGTRAINER_WORLDTOOL,
                  kTerrainTool = OSGTRAINER_TERRAINTOOL, kPmTool = OSGTRAINER_PMTOOL,
                  kRoadTool = OSGTRAINER_ROADTOOL;

INSTANTIATE_TEST_SUITE_P(
    Table, WrongCalls,
    testing::Values(
        WrongCall{"TrainerCapture",
                  {kTrainer, "tour", "HEREdem.tif", "--world-folder", "HEREworld", "--capture", "/proc/none"},
                  {"/proc/none: ", "cannot be made"},
                  {"dem.tif"}},
        WrongCall{
            "TrainerStats",
            {kTrainer, "tour", "HEREdem.tif", "--world-folder", "HEREworld", "--stats", "HEREnone/a.json"},
            {"none/a.json: ", "No such file"},
            {"dem.tif"}},
        WrongCall{"TrainerReport",
                  {kTrainer, "tour", "HEREdem.tif", "--world-folder", "HEREworld", "--report", "HEREfolder"},
                  {"folder: ", "is a folder"},
                  {"dem.tif"}},
        WrongCall{"TrainerView",
                  {kTrainer, "tour", "HEREdem.tif", "--world-folder", "HEREworld", "--view", "HEREnotes.txt"},
                  {"notes.txt"},
                  {"dem.tif"}},
        WrongCall{"TrainerScenery",
                  {kTrainer, "tour", "HEREdem.tif", "--scenery", "HEREnotes.txt"},
                  {"notes.txt"},
                  {"dem.tif"}},
        WrongCall{"TrainerNoRaster",
                  {kTrainer, "tour", "HEREnotes.txt", "--world-folder", "HEREworld"},
                  {"notes.txt: ", "in no format that GDAL reads"},
                  {}},
        WrongCall{"TrainerAircraft",
                  {kTrainer, "fly", "HEREdem.tif", "--frames", "1", "--aircraft", "HEREnone.xml"},
                  {"none.xml"},
                  {}},
        WrongCall{"TrainerVehicle",
                  {kTrainer, "drive", "HEREroads.xodr", "--frames", "1", "--vehicle", "HEREnone.xml"},
                  {"none.xml"},
                  {}},
        WrongCall{"WorldToolOutput",
                  {kWorldTool, "build", "HEREdem.tif", "-o", "/proc/none"},
                  {"/proc/none: ", "cannot be made"},
                  {"dem.tif"}},
        WrongCall{"WorldToolRunways",
                  {kWorldTool, "build", "HEREdem.tif", "--runways", "HEREnone.csv", "-o", "HEREworld"},
                  {"none.csv: ", "no such file"},
                  {"dem.tif"}},
        WrongCall{"WorldToolMap",
                  {kWorldTool, "build", "HEREdem.tif", "--map", "HEREnone.osm", "-o", "HEREworld"},
                  {"none.osm: ", "no such file"},
                  {"dem.tif"}},
        WrongCall{
            "WorldToolSecondMap",
            {kWorldTool, "build", "HEREdem.tif", "--map", "HEREmap.osm", "HEREnotes.txt", "-o", "HEREworld"},
            {"notes.txt: ", "in no format of maps"},
            {"dem.tif"}},
        WrongCall{"WorldToolMapFolder",
                  {kWorldTool, "build", "HEREdem.tif", "--map", "HEREmap.osm", "--map", "HEREfolder", "-o",
                   "HEREworld"},
                  {"folder: ", "is a folder without a map"},
                  {"dem.tif"}},
        WrongCall{"WorldToolBounds",
                  {kWorldTool, "build", "HEREdem.tif", "--bounds", "9,46,8,47", "-o", "HEREworld"},
                  {"--bounds", "is no rectangle"},
                  {"dem.tif"}},
        WrongCall{"WorldToolJson",
                  {kWorldTool, "build", "HEREdem.tif", "-o", "HEREworld", "--json", "HEREfolder"},
                  {"folder: ", "is a folder"},
                  {"dem.tif"}},
        WrongCall{"TerrainToolJson",
                  {kTerrainTool, "info", "HEREdem.tif", "--json", "/proc/none"},
                  {"/proc/none: "},
                  {"dem.tif"}},
        WrongCall{"TerrainToolValidate",
                  {kTerrainTool, "validate", "HEREdem.tif", "--json", "HEREfolder"},
                  {"folder: ", "is a folder"},
                  {"dem.tif"}},
        WrongCall{"TerrainToolMt",
                  {kTerrainTool, "mt-build", "HEREdem.tif", "-o", "/proc/none.mt"},
                  {"/proc/none.mt: "},
                  {"dem.tif"}},
        WrongCall{"TerrainToolKinds",
                  {kTerrainTool, "mt-build", "HEREdem.tif", "HEREpoints.csv", "-o", "HEREa.mt"},
                  {"points.csv: ", "another kind"},
                  {"dem.tif", "points.csv"}},
        WrongCall{"TerrainToolPlan",
                  {kTerrainTool, "mt-plan", "HEREpoints.csv", "-o", "/proc/none"},
                  {"/proc/none: ", "cannot be made"},
                  {"points.csv"}},
        WrongCall{"PmToolBuild",
                  {kPmTool, "build", "HEREmodel.obj", "-o", "/proc/none.pm"},
                  {"/proc/none.pm: "},
                  {"model.obj"}},
        WrongCall{"PmToolSimplify",
                  {kPmTool, "simplify", "HEREmodel.obj", "--targets", "50", "--output", "/proc/none"},
                  {"/proc/none: ", "cannot be made"},
                  {"model.obj"}},
        WrongCall{"PmToolBake",
                  {kPmTool, "bake", "HEREmodel.obj", "--output", "HEREnotes.txt"},
                  {"notes.txt"},
                  {"model.obj"}},
        WrongCall{"PmToolConsolidate",
                  {kPmTool, "consolidate", "HEREmodel.obj", "--output", "/proc"},
                  {"/proc"},
                  {"model.obj"}},
        WrongCall{"PmToolJson",
                  {kPmTool, "info", "HEREmodel.obj", "--json", "HEREnone/a.json"},
                  {"none/a.json: "},
                  {"model.obj"}},
        WrongCall{"RoadToolJson",
                  {kRoadTool, "info", "HEREroads.xodr", "--json", "/proc/none"},
                  {"/proc/none: "},
                  {"roads.xodr"}},
        WrongCall{"RoadToolSvg",
                  {kRoadTool, "draw", "HEREroads.xodr", "--svg", "/proc/none.svg"},
                  {"/proc/none.svg: "},
                  {"roads.xodr"}},
        WrongCall{"RoadToolPng",
                  {kRoadTool, "draw", "HEREroads.xodr", "--svg", "HEREa.svg", "--png", "HEREfolder.png"},
                  {"folder.png: ", "is a folder"},
                  {"roads.xodr"}},
        WrongCall{"RoadToolValidate",
                  {kRoadTool, "validate", "HEREroads.xodr", "--json", "HEREfolder"},
                  {"folder: ", "is a folder"},
                  {"roads.xodr"}},
        WrongCall{"RoadToolMissing",
                  {kRoadTool, "draw", "HEREnone.xodr", "--svg", "HEREa.svg"},
                  {"none.xodr: ", "no such file"},
                  {}}),
    [](const testing::TestParamInfo<WrongCall>& call) { return std::string(call.param.name); });

TEST_F(CheapFirst, AWindowWithoutADisplayOpensNothing)
{
    OpenedFiles files(_place.path(""));
    for (const std::vector<std::string>& command : {std::vector<std::string>{"fly", "HEREdem.tif"},
                                                    {"drive", "HEREroads.xodr"},
                                                    {"tour", "HEREdem.tif", "--world-folder", "HEREworld"}})
    {
        std::vector<std::string> words{"env", "-u", "DISPLAY", kTrainer};
        words.insert(words.end(), command.begin(), command.end());
        words.push_back("--window");
        EXPECT_TRUE(failsWith(run(words), 1, "trainer", {"--window", "there is no display"}));
        EXPECT_FALSE(files.take().contains(command[1].substr(4))) << command[0];
    }
    EXPECT_FALSE(std::filesystem::exists(_place.path("world")));
}

/// The mutation: where nothing is wrong, the same files are opened, so the counts above can be other than
/// none.
TEST_F(CheapFirst, ARightCallOpensThem)
{
    OpenedFiles files(_place.path(""));
    const auto opens = [&](std::vector<std::string> command, const char* file)
    {
        (void)files.take();
        (void)run(std::move(command));
        EXPECT_TRUE(files.take().contains(file)) << file;
    };
    opens({kTerrainTool, "info", "HEREdem.tif"}, "dem.tif");
    opens({kTerrainTool, "mt-build", "HEREpoints.csv", "-o", "HEREa.mt"}, "points.csv");
    opens({kPmTool, "info", "HEREmodel.obj"}, "model.obj");
    opens({kRoadTool, "info", "HEREroads.xodr"}, "roads.xodr");
    opens({kWorldTool, "build", "HEREdem.tif", "-o", "HEREworld"}, "dem.tif");
    opens({kTrainer, "tour", "HEREdem.tif", "--world-folder", "HEREmade", "--frames", "1", "--size", "32x18",
           "--samples", "1"},
          "dem.tif");
    EXPECT_TRUE(std::filesystem::exists(_place.path("made")));
}

} // namespace
