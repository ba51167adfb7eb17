// SPDX-License-Identifier: Apache-2.0
// Scenarios that cannot be played: exit code 1, one line that names file and line, no picture and no figure left.
#include <algorithm>

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

TEST(ScenarioErrors, AreNotElementsThatArePassedOver)
{
    const Workplace place;
    const std::string text = with(driveText("hill.tif"), "<TeleportAction>", "<FlyAction/><TeleportAction>");
    const ProgramRun run = runTrainer(play(place, place.write("odd.xosc", text)));
    EXPECT_TRUE(succeeds(run)) << run.text();
    const std::string warning =
        "warning: " + place.path("odd.xosc") + ":" + lineOf(text, "<FlyAction/>") + ": ";
    EXPECT_TRUE(run.errors.starts_with(warning)) << run.text();
}

TEST(ScenarioErrors, LeaveAGoodScenarioAlone)
{
    const Workplace place;
    place.write("good.xosc", driveText("hill.tif"));
    EXPECT_TRUE(succeeds(runTrainer(play(place, place.path("good.xosc")))));
}

} // namespace
