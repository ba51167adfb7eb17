// SPDX-License-Identifier: Apache-2.0
// One command from anybody's recording to pictures of it.
#include <cstdio>
#include <fstream>

#include "Playing.h"
#include "simulation/record/MotionTable.h"

namespace
{

/// A flight of a minute over the example raster, 200 m above it, with a broken line.
std::string igcOver(double latitudeDeg, double longitudeDeg)
{
    std::string text = "AXXX001\nHFDTE170621\n";
    for (int i = 0; i < 60; ++i)
    {
        char line[64];
        std::snprintf(
            line, sizeof line, "B1200%02d%02d%05.0fN%03d%05.0fEA0180001800\n", i,
            static_cast<int>(latitudeDeg), (latitudeDeg - static_cast<int>(latitudeDeg)) * 60000.0 + i * 9,
            static_cast<int>(longitudeDeg), (longitudeDeg - static_cast<int>(longitudeDeg)) * 60000.0);
        text += line;
    }
    return text + "B12\n";
}

TEST(TrackPlay, ARecordingIsPlayedOverItsTerrainAndSavedAsAScenario)
{
    const Workplace place;
    RasterSpec spec;
    spec.columns = spec.rows = 65;
    spec.geoTransform = northUp3Seconds(65);
    spec.epsg = 4326;
    writeRaster(place.path("dem.tif"), "GTiff", spec);
    writeBytes(place.path("flight.igc"), igcOver(46.015, 8.025));
    const Playing playing =
        playedAs(place, "track", {"play", place.path("flight.igc")},
                 {"--terrain", place.path("dem.tif"), "--frames", "4", "--size", "96x54", "--eye", "chase",
                  "--start", "10", "--save", place.path("flight.xosc")});
    EXPECT_EQ(playing.frames.size(), 4U);
    // What was saved gives the same pictures.
    const Playing again = playedAs(place, "again", {"play", place.path("flight.xosc")},
                                   {"--frames", "4", "--size", "96x54", "--eye", "chase"});
    EXPECT_EQ(playing.frames, again.frames);
    // Another moment of it does not.
    const Playing later = playedAs(place, "later", {"play", place.path("flight.igc")},
                                   {"--terrain", place.path("dem.tif"), "--frames", "4", "--size", "96x54",
                                    "--eye", "chase", "--start", "40"});
    EXPECT_NE(playing.frames, later.frames);
}

TEST(TrackPlay, SaysWhatWasPassedOverAndWhatIsWrong)
{
    const Workplace place;
    writeBytes(place.path("flight.igc"), igcOver(46.015, 8.025));
    const ProgramRun run = runTrainer({"play", place.path("flight.igc"), "--frames", "1", "--size", "16x16"});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_NE(run.errors.find("flight.igc:63: a B record of 3 characters"), std::string::npos) << run.errors;
    EXPECT_NE(run.output.find("flat ground is made"), std::string::npos) << run.output;
    writeBytes(place.path("none.igc"), "AXXX\nB12\n");
    const ProgramRun none = runTrainer({"play", place.path("none.igc")});
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_NE(none.errors.find("none.igc:2: no position can be read"), std::string::npos) << none.errors;
}

TEST(TrackPlay, ARecordingIsPlayedHeadlessAtItsHeights)
{
    const Workplace place;
    writeBytes(place.path("fl\xC3\xBCge, alle.csv"),
               "\xEF\xBB\xBFtime;lat;lon;alt msl\n0;48,735;8,97;480\n10;48,736;8,97;484\n");
    const std::string log = place.path("log.csv");
    const std::vector<std::string> line{"play", place.path("fl\xC3\xBCge, alle.csv"), "--headless",
                                        "--csv_logger", log};
    EXPECT_TRUE(succeeds(runTrainer(line)));
    const auto heightsOf = [&]
    {
        const auto table = simulation::readMotionTable(log);
        EXPECT_TRUE(table) << table.error().message();
        const auto& samples = table->tracks.at(0).samples;
        EXPECT_EQ(table->tracks[0].entity, "fl\xC3\xBCge, alle");
        return std::pair(samples.front()->position.z, samples.back()->position.z);
    };
    EXPECT_NEAR(heightsOf().first, 480.0, 0.01);
    EXPECT_NEAR(heightsOf().second, 484.0, 0.01);
    EXPECT_TRUE(succeeds(runTrainer({"compare", log, log})));
    auto other = line;
    other.insert(other.end(), {"--heights-above", "ellipsoid"});
    EXPECT_TRUE(succeeds(runTrainer(other)));
    EXPECT_NEAR(heightsOf().first, 480.0 - 48.66, 0.05);
    // The strings of the table as any reader of CSV takes them: a quote right behind the comma.
    std::ifstream stream(log);
    std::string row;
    for (int i = 0; i < 5; ++i)
        std::getline(stream, row);
    EXPECT_NE(row.find(",\"fl\xC3\xBCge, alle\", 0, "), std::string::npos) << row;
}

} // namespace
