// SPDX-License-Identifier: Apache-2.0
// Sun, moonlight and visibility of a world file in the pictures of the trainer: a scenario goes before them,
// the usual after them.
#include <fstream>
#include <iterator>

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
                      night = pictureOf(place, "sun = 180 -30\nmoonlight = 1\n", play);
    EXPECT_NE(usual, night);
    const ProgramRun run = runTrainer({"play", drive, "--frames", "1", "--size", "64x36", "--samples", "1"});
    EXPECT_NE(
        run.output.find("note: the scenario has no TimeOfDay in Init; the sun stands as the world file says"),
        std::string::npos)
        << run.text();
}

} // namespace
