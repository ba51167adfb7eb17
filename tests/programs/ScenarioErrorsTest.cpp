// SPDX-License-Identifier: Apache-2.0
// Scenarios that cannot be played: exit code 1, one line that names file and line, no picture and no figure
// left.
#include <algorithm>

#include "HillsText.h"
#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

/// One thing wrong with a good scenario.
struct BadScenario
{
    const char* name;
    std::string replaced; ///< in the text of the drive over hill.tif
    std::string by;
    std::vector<std::string> words; ///< of the message; LINE: file and line of what was replaced
};

/// Arguments that ask for every kind of result.
std::vector<std::string> play(const Workplace& place, const std::string& scenario)
{
    return {"play",  scenario,  "--capture",          place.path("frames"), "--size",
            "64x36", "--stats", place.path("s.json"), "--report",           place.path("r.html")};
}

/// Counted from 1.
std::string lineOf(const std::string& text, const std::string& part)
{
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(text.find(part), text.size()));
    return std::to_string(1 + std::count(text.begin(), end, '\n'));
}

class ScenarioErrors : public testing::TestWithParam<BadScenario>
{
};

TEST_P(ScenarioErrors, AreOneLineThatNamesThePlace)
{
    const Workplace place;
    place.write("garbage.osgt", "this is no scene\n");
    place.write("garbage.xyz", "nor is this\n");
    place.write("garbage.tif", "this is no raster\n");
    const std::string good = driveText("hill.tif");
    place.write("bad.xosc", with(good, GetParam().replaced, GetParam().by));
    const auto before = place.files();
    std::vector<std::string> words = GetParam().words;
    if (words.front() == "LINE") words.front() = "bad.xosc:" + lineOf(good, GetParam().replaced) + ": ";
    EXPECT_TRUE(failsWith(runTrainer(play(place, place.path("bad.xosc"))), 1, "trainer", words));
    EXPECT_EQ(place.files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Table, ScenarioErrors,
    testing::Values(BadScenario{"Malformed", "</Entities>", "</Entitees>", {"LINE", "not well-formed XML"}},
                    BadScenario{"UnknownEntity",
                                "<Private entityRef=\"Ego\"",
                                "<Private entityRef=\"Egon\"",
                                {"LINE", "did you mean Ego?"}},
                    BadScenario{"NoEntities",
                                "<ScenarioObject name=\"Ego\">" + simulation::kCar + "</ScenarioObject>",
                                "",
                                {"bad.xosc"}},
                    BadScenario{"SceneMissing", "hill.tif", "hole.tif", {"hole.tif: ", "no such file"}},
                    BadScenario{
                        "SceneOfNoFormat", "hill.tif", "garbage.osgt", {"garbage.osgt: ", "OpenSceneGraph"}},
                    BadScenario{"SceneOfNoKnownName",
                                "hill.tif",
                                "garbage.xyz",
                                {"garbage.xyz: ", "in no format that GDAL reads"}},
                    BadScenario{"ModelOfNoFormat",
                                "vehicleCategory=",
                                "model3d=\"garbage.osgt\" vehicleCategory=",
                                {"garbage.osgt: ", "another model3d"}},
                    BadScenario{"SceneNoRaster", "hill.tif", "garbage.tif", {"garbage.tif: "}},
                    BadScenario{"SceneOfALongName", "hill.tif", std::string(5000, 'x'), {"no such file"}},
                    BadScenario{"NoNumber", "x=\"-600\"", "x=\"far\"", {"LINE", "\"far\""}}),
    [](const testing::TestParamInfo<BadScenario>& test) { return std::string(test.param.name); });

TEST(ScenarioErrors, NameTheLineOfMalformedText)
{
    const Workplace place;
    place.write("bad.xosc", "<OpenSCENARIO>\n<FileHeader>\n\n</FileHaeder>\n</OpenSCENARIO>\n");
    EXPECT_TRUE(failsWith(runTrainer({"play", place.path("bad.xosc")}), 1, "trainer", {"bad.xosc:4: "}));
    EXPECT_TRUE(failsWith(runTrainer({"check", place.path("bad.xosc")}), 1, "trainer", {"bad.xosc:4: "}));
}

TEST(ScenarioErrors, CoverFilesThatHoldNoScenario)
{
    const Workplace place;
    place.write("empty.xosc", "");
    place.write("web.xosc", "<html>\n</html>\n");
    const auto before = place.files();
    for (const std::string name : {"none.xosc", "empty.xosc", "web.xosc", "hill.tif", ""})
        EXPECT_TRUE(failsWith(runTrainer(play(place, place.path(name))), 1, "trainer", {place.path(name)}));
    EXPECT_TRUE(failsWith(runTrainer(play(place, std::string(5000, 'x'))), 1, "trainer", {"no such file"}));
    EXPECT_EQ(place.files(), before);
}

/// Those of other programs, which no element of the standard is like. One with a slip in it was meant to be
/// one of the standard (`<SpeedActn>` was passed over once, and the car stood for all of the play).
TEST(ScenarioErrors, AreNotElementsThatArePassedOver)
{
    const Workplace place;
    std::string slip = with(driveText("hill.tif"), "<TeleportAction>", "<TeleportActn>");
    slip = with(slip, "</TeleportAction>", "</TeleportActn>");
    EXPECT_TRUE(failsWith(runTrainer(play(place, place.write("slip.xosc", slip))), 1, "trainer",
                          {"slip.xosc:" + lineOf(slip, "<TeleportActn>") + ": ", "the action TeleportActn",
                           "did you mean TeleportAction?"}));
    const std::string text = with(driveText("hill.tif"), "<TeleportAction>", "<FlyAction/><TeleportAction>");
    const ProgramRun run = runTrainer(play(place, place.write("odd.xosc", text)));
    EXPECT_TRUE(succeeds(run)) << run.text();
    const std::string warning =
        "warning: " + place.path("odd.xosc") + ":" + lineOf(text, "<FlyAction/>") + ": ";
    EXPECT_TRUE(run.errors.starts_with(warning)) << run.text();
}

/// An aircraft, which no ground carries.
const std::string kPlane = R"(<MiscObject name="aircraft" miscObjectCategory="none" mass="1100">
<BoundingBox><Center x="0" y="0" z="1"/><Dimensions width="11" length="8" height="2"/></BoundingBox>
<Properties><Property name="domain" value="air"/></Properties></MiscObject>)";

/// The hill of Workplace, 65 x 65 samples of 30 m, ends 960 m from the middle; there the ground lies at some
/// 350 m.
class StartsOffTheGround : public testing::Test
{
protected:
    /// A scenario whose only entity begins at a position.
    std::string starting(const std::string& name, const std::string& position,
                         const std::string& object = simulation::kCar) const
    {
        const std::string there =
            with(driveText("hill.tif"), "<WorldPosition x=\"-600\" y=\"0\"/>", position);
        return _place.write(name, with(there, simulation::kCar, object));
    }

    void expectRefused(const std::string& scenario, std::vector<std::string> words) const
    {
        words.push_back(scenario);
        EXPECT_TRUE(failsWith(runTrainer(play(_place, scenario)), 1, "trainer", words));
    }

    void expectPlayed(const std::string& scenario, const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> words = play(_place, scenario);
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_TRUE(succeeds(runTrainer(words)));
    }

    const Workplace _place;
};

TEST_F(StartsOffTheGround, AreOneLineWithTheExtentOfTheGround)
{
    const std::string beyond = starting("beyond.xosc", "<WorldPosition x=\"-1600\" y=\"0\"/>");
    const std::string elsewhere =
        starting("elsewhere.xosc", "<GeoPosition latitudeDeg=\"46.5\" longitudeDeg=\"8.5\"/>");
    const std::string far = starting("far.xosc", "<WorldPosition x=\"-25000\" y=\"0\" z=\"900\"/>", kPlane);
    const std::string below = starting("below.xosc", "<WorldPosition x=\"-600\" y=\"0\" z=\"200\"/>", kPlane);
    const auto files = _place.files();
    expectRefused(beyond, {"Ego begins at x -1600 m, y 0 m, 6", " m from the ground, which reaches from x -9",
                           "--terrain"});
    expectRefused(elsewhere, {"Ego begins at latitude 46.5000, longitude 8.5000, ",
                              " km from the ground, which reaches from latitude 43.", "--terrain"});
    expectRefused(far, {"Ego begins at x -25000 m", " 24 km from the ground", "--terrain"});
    expectRefused(below, {"Ego begins at x -600 m", " m below the ground", "height"});
    EXPECT_EQ(_place.files(), files);
}

/// The controls: each differs in one thing from one that is refused.
TEST_F(StartsOffTheGround, AreNotThoseThatSeeIt)
{
    expectPlayed(starting("within.xosc", "<WorldPosition x=\"-900\" y=\"0\"/>"));
    expectPlayed(starting("near.xosc", "<WorldPosition x=\"-15000\" y=\"0\" z=\"900\"/>", kPlane));
    expectPlayed(starting("above.xosc", "<WorldPosition x=\"-600\" y=\"0\" z=\"400\"/>", kPlane));
    // The ground carries a car, whatever its height in the file.
    expectPlayed(starting("carried.xosc", "<WorldPosition x=\"-600\" y=\"0\" z=\"200\"/>"));
    // An eye that has a place of its own.
    expectPlayed(starting("beyond.xosc", "<WorldPosition x=\"-1600\" y=\"0\"/>"),
                 {"--eye", "free", "--eye-at", "0,0,900,0,-20"});
}

/// A road tells the height of a car on it: that of physics.xosc lies at 120 m.
TEST_F(StartsOffTheGround, AreThoseOnRoadsBelowIt)
{
    const std::string onRoad = with(
        readBytes(starting("road.xosc", "<LanePosition roadId=\"1\" laneId=\"-1\" s=\"60\"/>")),
        "<SceneGraphFile",
        "<LogicFile filepath=\"" OSGTRAINER_SOURCE_DIR "/data/scenarios/physics.xodr\"/><SceneGraphFile");
    expectRefused(_place.write("road.xosc", onRoad),
                  {"Ego begins at x 60 m, y -2 m, ", " m below the ground"});
}

/// The scenarios begin on the default terrain, which lies elsewhere.
TEST_F(StartsOffTheGround, AreThoseOfTheProjectsScenariosOverOtherGround)
{
    (void)_place.write("there.prj",
                       "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
                       "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]");
    const std::string there = _place.write("there.asc", hillsText());
    const auto over = [&](const std::string& name, const std::string& entity)
    {
        return runTrainer({"play", OSGTRAINER_SOURCE_DIR "/data/scenarios/" + name + ".xosc", "--terrain",
                           there, "--eye-entity", entity, "--frames", "1", "--size", "64x36"});
    };
    for (const auto& [name, entity] :
         {std::pair{"flight", "ownship"}, std::pair{"drive", "car"}, std::pair{"drive-and-flight", "car"},
          std::pair{"drive-and-flight", "aircraft"}})
        EXPECT_TRUE(
            failsWith(over(name, entity), 1, "trainer",
                      {std::string(entity) + " begins at latitude 43.", " km from the ground", "--terrain"}));
    // One that drives by its own physics is refused by that, behind warnings.
    const ProgramRun physics = over("physics", "ego");
    EXPECT_EQ(physics.exitCode, 1);
    EXPECT_NE(physics.errors.find("trainer: ego, the start at 60 m east"), std::string::npos)
        << physics.text();
    EXPECT_NE(physics.errors.find("m inside the ground"), std::string::npos) << physics.text();
}

TEST(ScenarioErrors, LeaveAGoodScenarioAlone)
{
    const Workplace place;
    place.write("good.xosc", driveText("hill.tif"));
    EXPECT_TRUE(succeeds(runTrainer(play(place, place.path("good.xosc")))));
}

} // namespace
