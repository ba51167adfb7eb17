// SPDX-License-Identifier: Apache-2.0
// What people mix up or misspell is told in one line with the remedy; nothing plays on in silence.
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

using Words = std::vector<std::string>;

const std::string kTree = OSGTRAINER_SOURCE_DIR;

ProgramRun flown(Words more)
{
    Words all{"fly", "--aircraft", kTree + "/data/aircraft/c172p.xml", "--headless", "--duration", "1"};
    all.insert(all.end(), more.begin(), more.end());
    return runTrainer(all);
}

ProgramRun driven(const std::string& vehicle, Words more)
{
    Words all{"drive", kTree + "/data/street.xodr", "--headless", "--duration", "1", "--vehicle", vehicle};
    all.insert(all.end(), more.begin(), more.end());
    return runTrainer(all);
}

/// A file of the tree with one text for another.
std::string changed(const Workplace& place, const std::string& file, const std::string& from,
                    const std::string& to)
{
    std::ifstream stream(kTree + "/data/" + file);
    const std::string text((std::istreambuf_iterator<char>(stream)), {});
    return place.write("changed-" + std::filesystem::path(file).filename().string(), with(text, from, to));
}

TEST(ToldMistakes, AWindWhoseNumbersAreSwapped)
{
    EXPECT_TRUE(succeeds(flown({"--strip", "0,0,0,800", "--wind", "240,12"})));
    EXPECT_TRUE(failsWith(flown({"--strip", "0,0,0,800", "--wind", "12,240"}), 1, "trainer",
                          {"--wind", "240 kt", "did you mean 240,12?"}));
    EXPECT_TRUE(failsWith(flown({"--strip", "0,0,0,800", "--wind", "400,12"}), 1, "trainer",
                          {"--wind", "0 to 360 degrees"}));
}

TEST(ToldMistakes, AStartWherePowerLacks)
{
    EXPECT_TRUE(
        failsWith(flown({"--strip", "0,0,0,800", "--start", "0,0,3500,0,50"}), 1, "trainer",
                  {"power lacks for steady flight at 50 m/s", "path that is", "choose a lower height"}));
    EXPECT_TRUE(
        failsWith(flown({"--strip", "0,0,0,800", "--start", "0,0,4000,0,50"}), 1, "trainer",
                  {"power lacks for steady flight at 50 m/s in the thin air", "choose a lower height"}));
    EXPECT_TRUE(failsWith(flown({"--strip", "0,0,0,800", "--start", "0,0,300,0,12"}), 1, "trainer",
                          {"no steady flight was found at 12 m/s"}));
    EXPECT_TRUE(succeeds(flown({"--strip", "0,0,0,800", "--start", "0,0,1500,0,50"})));
}

TEST(ToldMistakes, VehiclesInOtherUnitsOrWithMisspeltNames)
{
    const Workplace place;
    const auto fliesBy = [&](const std::string& file) {
        return runTrainer(
            {"fly", "--strip", "0,0,0,800", "--headless", "--duration", "1", "--aircraft", file});
    };
    EXPECT_TRUE(failsWith(fliesBy(changed(place, "aircraft/c172p.xml", "<empty source=\"c172p\" massKg",
                                          "<empty source=\"c172p\" masKg")),
                          1, "trainer", {"changed-c172p.xml:", "'masKg'", "did you mean massKg?"}));
    EXPECT_TRUE(failsWith(fliesBy(changed(place, "aircraft/c172p.xml", "<geometry ", "<geometri ")), 1,
                          "trainer", {"<geometri> is unknown", "did you mean geometry?"}));
    EXPECT_TRUE(
        failsWith(fliesBy(changed(place, "aircraft/c172p.xml", "xM=\"1.0414\" yM=\"0\" zM=\"0.9271\"",
                                  "xM=\"41\" yM=\"0\" zM=\"36.5\"")),
                  1, "trainer",
                  {"changed-c172p.xml:", "centre of mass of <empty> lies", "metres (1 inch is 0.0254 m)"}));
    EXPECT_TRUE(failsWith(driven(changed(place, "vehicles/car.xml", "mostNm=\"7000\"", "mostNm=\"7\""), {}),
                          1, "trainer", {"changed-car.xml:", "mostNm of 7 slows the vehicle by", "Nm"}));
}

TEST(ToldMistakes, ALookThatIsNone)
{
    const Workplace place;
    const std::string car =
        changed(place, "vehicles/car.xml", "version=\"1\"", "version=\"1\" look=\"look.json\"");
    EXPECT_TRUE(failsWith(driven(car, {}), 1, "trainer", {"look.json: cannot be read"}));
    place.write("look.json", R"({"name": "mine", "like": "saloon", "wheels": {"radiusM": 3}})");
    EXPECT_TRUE(failsWith(driven(car, {}), 1, "trainer",
                          {"look.json: /wheels/radiusM: is out of range", "give one from 0.1 to 1"}));
    place.write("look.json", R"({"name": "mine", "like": "saloon"})");
    EXPECT_TRUE(succeeds(driven(car, {})));
}

TEST(ToldMistakes, AStartBeyondTheWay)
{
    const std::string car = kTree + "/data/vehicles/car.xml";
    EXPECT_TRUE(succeeds(driven(car, {"--start-at", "100"})));
    EXPECT_TRUE(failsWith(driven(car, {"--start-at", "5000"}), 1, "trainer",
                          {"--start-at: 5000 m is beyond the way, which is 260 m long", "give less"}));
}

TEST(ToldMistakes, InputsWithoutAGear)
{
    const Workplace place;
    const std::string car = kTree + "/data/vehicles/car.xml";
    const std::string neutral =
        place.write("neutral.txt", "osgtrainer-inputs 1\ncolumns time throttle\n0 0.5\n");
    const ProgramRun run = driven(car, {"--inputs", neutral});
    EXPECT_TRUE(succeeds(run));
    EXPECT_NE(run.output.find("no column gear: the vehicle stays in neutral"), std::string::npos)
        << run.text();
    const std::string geared =
        place.write("geared.txt", "osgtrainer-inputs 1\ncolumns time throttle gear\n0 0.5 1\n");
    EXPECT_EQ(driven(car, {"--inputs", geared}).output.find("neutral"), std::string::npos);
}

TEST(ToldMistakes, OptionsThatHeadlessLeavesWithoutEffect)
{
    const Workplace place;
    const std::string keys = place.write("keys.txt", "osgtrainer-keys 1\n");
    for (const auto& [option, value] : {std::array<std::string, 2>{"--keys", keys},
                                        {"--sound", place.path("a.wav")},
                                        {"--capture", place.path("pictures")},
                                        {"--stats", place.path("stats.json")}})
        EXPECT_TRUE(failsWith(flown({"--strip", "0,0,0,800", option, value}), 2, "trainer",
                              {option + ": has no effect with --headless", "leave one of the two out"}));
    EXPECT_TRUE(failsWith(flown({"--strip", "0,0,0,800", "--fullscreen"}), 2, "trainer", {"--fullscreen"}));
}

TEST(ToldMistakes, SoundInAnotherFormatThanItsName)
{
    const Workplace place;
    EXPECT_TRUE(failsWith(runTrainer({"tour", place.hill(), "--sound", place.path("a.mp3")}), 2, "trainer",
                          {"--sound", "a.mp3", "does not end in .wav"}));
}

TEST(ToldMistakes, AFileOfAnotherKindInPlaceOfElevation)
{
    const Workplace place;
    for (const auto& [name, what, command] :
         {std::array<const char*, 3>{"a.osm.pbf", "is a map of OpenStreetMap", "worldtool build"},
          {"a.xosc", "is a scenario", "trainer play"},
          {"a.glb", "is a model", "pmtool"},
          {"a.igc", "is a recorded flight", "trainer play"}})
        EXPECT_TRUE(failsWith(runTrainer({"fly", place.write(name, "<text/>"), "--headless"}), 1, "trainer",
                              {name, what, command}));
}

TEST(ToldMistakes, AWindowThatNobodyAskedForIsNoOption)
{
    const ProgramRun run = runProgram({"env", "-u", "DISPLAY", OSGTRAINER_TRAINER, "fly", "--strip",
                                       "0,0,0,800", "--aircraft", kTree + "/data/aircraft/c172p.xml"});
    EXPECT_NE(run.errors.find("the window: there is no display"), std::string::npos) << run.text();
    EXPECT_EQ(run.errors.find("--window"), std::string::npos) << run.text();
}

/// Heights at the end count from the sea: the hill's raster counts from there, and bends with the Earth.
TEST(ToldMistakes, TheEndOfAFlightIsTold)
{
    const Workplace place;
    const ProgramRun run =
        runTrainer({"fly", place.hill(), "--aircraft", kTree + "/data/aircraft/c172p.xml", "--headless",
                    "--duration", "40", "--start", "0,0,500,90,60", "--orders", "wait 40"});
    EXPECT_TRUE(succeeds(run)) << run.text();
    EXPECT_NE(run.output.find("m above the sea"), std::string::npos) << run.text();
    EXPECT_NE(run.output.find("beyond the elevation data"), std::string::npos) << run.text();
}

std::string scenarioOnRoad(const std::string& logicFile, const std::string& roadId, int lane, double sM)
{
    std::string text = driveText("");
    const std::size_t begin = text.find("<RoadNetwork"), end = text.find("</RoadNetwork>");
    text =
        text.substr(0, begin) + "<RoadNetwork><LogicFile filepath=\"" + logicFile + "\"/>" + text.substr(end);
    const std::size_t at = text.find("<WorldPosition"), close = text.find("/>", at);
    return text.substr(0, at) + "<LanePosition roadId=\"" + roadId + "\" laneId=\"" + std::to_string(lane) +
           "\" s=\"" + std::to_string(sM) + "\"/>" + text.substr(close + 2);
}

TEST(ToldMistakes, AScenarioOnRoadsThatAreNotThere)
{
    const Workplace place;
    const std::string street = kTree + "/data/street.xodr";
    const auto checked = [&](const std::string& text, Words more = {})
    {
        Words all{"check", place.write("roads.xosc", text)};
        all.insert(all.end(), more.begin(), more.end());
        return runTrainer(all);
    };
    EXPECT_TRUE(succeeds(checked(scenarioOnRoad(street, "1", -1, 10.0), {"--strict"})));
    EXPECT_TRUE(
        failsWith(checked(scenarioOnRoad("missing.xodr", "1", -1, 10.0)), 1, "trainer", {"1 problem"}));
    const ProgramRun road = checked(scenarioOnRoad(street, "99", -1, 10.0));
    EXPECT_TRUE(failsWith(road, 1, "trainer", {"1 problem"}));
    EXPECT_NE(road.output.find("the road 99 does not exist"), std::string::npos) << road.text();
    const ProgramRun lane = checked(scenarioOnRoad(street, "1", -33, 10.0));
    EXPECT_TRUE(failsWith(lane, 1, "trainer", {"1 problem"}));
    EXPECT_NE(lane.output.find("the road 1 has no lane -33"), std::string::npos) << lane.text();
    const std::string lost = place.write("lost.xosc", scenarioOnRoad(street, "99", -1, 10.0));
    EXPECT_TRUE(
        failsWith(runTrainer({"play", lost, "--headless"}), 1, "trainer", {"the road 99 does not exist"}))
        << "nobody plays at the origin";
    const ProgramRun beyond = checked(scenarioOnRoad(street, "1", -1, 99999.0));
    EXPECT_TRUE(failsWith(beyond, 1, "trainer", {"1 problem"}));
    EXPECT_NE(beyond.output.find("is beyond the road 1"), std::string::npos) << beyond.text();
}

} // namespace
