// SPDX-License-Identifier: Apache-2.0
// Sun, moonlight and visibility of a world file in the pictures of the trainer: a scenario goes before them,
// the usual after them, which is by day wherever the world lies.
#include <fstream>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

std::string bytesAt(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The picture of a world with these keys.
std::string pictureOf(const Workplace& place, const std::string& keys, std::vector<std::string> command)
{
    const std::string world = place.write("air.roam", "dem = hill.tif\n" + keys),
                      folder = place.path("pictures");
    for (std::string& word : command)
        if (word == "WORLD") word = world;
    command.insert(command.end(),
                   {"--frames", "1", "--size", "64x36", "--samples", "1", "--capture", folder});
    const ProgramRun run = runTrainer(command);
    EXPECT_TRUE(succeeds(run)) << run.text();
    return bytesAt(folder + "/frame_00000.png");
}

TEST(WorldAir, LightsATourUnlessAnHourIsGiven)
{
    const Workplace place;
    const std::vector<std::string> tour{"tour", "WORLD"};
    const std::string usual = pictureOf(place, "", tour),
                      dark = pictureOf(place, "sun = 180 -30\nmoonlight = 0\n", tour),
                      moonlit = pictureOf(place, "sun = 180 -30\nmoonlight = 1\n", tour),
                      hazy = pictureOf(place, "visibility = 300\n", tour);
    EXPECT_FALSE(usual.empty());
    EXPECT_NE(usual, dark) << "the sun of the world file";
    EXPECT_NE(dark, moonlit) << "its moon";
    EXPECT_NE(usual, hazy) << "its air";
    const std::string aircraft = OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml";
    const std::vector<std::string> noon{"fly", "WORLD", "--aircraft", aircraft, "--time", "12:00"};
    EXPECT_EQ(pictureOf(place, "", noon), pictureOf(place, "sun = 180 -30\n", noon))
        << "the hour goes before it";
}

TEST(WorldAir, SnowOfTheWorldLiesUnlessTheCommandLineSaysOtherwise)
{
    const Workplace place;
    const std::vector<std::string> tour{"tour", "WORLD"}, dry{"tour", "WORLD", "--ground", "dry"},
        snow{"tour", "WORLD", "--ground", "snow 20"};
    const std::string usual = pictureOf(place, "", tour),
                      white = pictureOf(place, "ground = snow 20\n", tour);
    EXPECT_NE(usual, white);
    EXPECT_EQ(pictureOf(place, "", snow), white);
    EXPECT_EQ(pictureOf(place, "ground = snow 20\n", dry), usual);
    const ProgramRun run = runTrainer({"tour", place.path("air.roam"), "--ground", "mud"});
    EXPECT_NE(run.text().find("'mud' is nothing on the ground"), std::string::npos) << run.text();
}

TEST(WorldAir, LightsAScenarioThatHasNoTimeOfDay)
{
    const Workplace place;
    const std::string drive = place.write("drive.xosc", driveText("air.roam"));
    const std::vector<std::string> play{"play", drive};
    const std::string usual = pictureOf(place, "", play),
                      night = pictureOf(place, "sun = 180 -30\nmoonlight = 1\n", play),
                      dark = pictureOf(place, "sun = 180 -30\nmoonlight = 0\n", play);
    EXPECT_NE(usual, night) << "the sun of the world file";
    EXPECT_NE(night, dark) << "its moon";
    EXPECT_NE(usual, pictureOf(place, "visibility = 300\n", play)) << "its air";
    pictureOf(place, "sun = 180 -30\n", play);
    const ProgramRun run = runTrainer({"play", drive, "--frames", "1", "--size", "64x36", "--samples", "1"});
    EXPECT_NE(
        run.output.find("note: the scenario has no TimeOfDay in Init; the sun stands as the world file says"),
        std::string::npos)
        << run.text();
}

/// A drive over a terrain, with the time of day that is told; empty: none is.
std::string drivenAt(const std::string& terrain, const std::string& dateTime)
{
    const std::string text = driveText(terrain);
    if (dateTime.empty()) return text;
    return with(text, "<Actions>",
                "<Actions><GlobalAction><EnvironmentAction><Environment name=\"air\"><TimeOfDay "
                "animation=\"false\" dateTime=\"" +
                    dateTime + "\"/></Environment></EnvironmentAction></GlobalAction>");
}

/// It was deep night over America, without a word.
TEST(WorldAir, WithoutAnyTimeItIsTenOClockByTheLongitudeOfTheWorld)
{
    const Workplace place;
    place.writeHill("west.tif", 0.0, 32613); // 105.8° W: ten o'clock there is 17:00 UTC
    std::string said;
    const auto pictureAt = [&](const std::string& terrain, const std::string& dateTime)
    {
        const std::string drive = place.write("timed.xosc", drivenAt(terrain, dateTime)),
                          folder = place.path("timed");
        const ProgramRun run = runTrainer(
            {"play", drive, "--frames", "1", "--size", "64x36", "--samples", "1", "--capture", folder});
        EXPECT_TRUE(succeeds(run)) << run.text();
        said = run.output;
        return bytesAt(folder + "/frame_00000.png");
    };
    const std::string note = "note: the scenario has no TimeOfDay in Init; it is 10 o'clock in June, by "
                             "whole hours of longitude";
    for (const auto& [terrain, tenOClock, other] :
         {std::tuple("west.tif", "2024-06-21T17:00:00Z", "2024-06-21T10:00:00Z"),
          std::tuple("hill.tif", "2024-06-21T10:00:00Z", "2024-06-21T17:00:00Z")})
    {
        const std::string silent = pictureAt(terrain, "");
        EXPECT_NE(said.find(note), std::string::npos) << said;
        EXPECT_FALSE(silent.empty());
        EXPECT_EQ(silent, pictureAt(terrain, tenOClock)) << terrain;
        EXPECT_EQ(said.find("no TimeOfDay"), std::string::npos) << "it is told: " << said;
        EXPECT_NE(silent, pictureAt(terrain, other)) << terrain << ": the control, at another hour";
    }
}

} // namespace
