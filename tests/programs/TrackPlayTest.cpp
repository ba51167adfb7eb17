// SPDX-License-Identifier: Apache-2.0
// One command from anybody's recording to pictures of it.
#include <cstdio>

#include "Playing.h"

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
    const ProgramRun headless = runTrainer({"play", place.path("flight.igc"), "--headless"});
    EXPECT_EQ(headless.exitCode, 1);
    EXPECT_NE(headless.errors.find("--save"), std::string::npos) << headless.errors;
}

} // namespace
