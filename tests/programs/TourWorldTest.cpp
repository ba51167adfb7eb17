// SPDX-License-Identifier: Apache-2.0
// The worlds that the trainer shows where nobody names one: made up over a raster, once, and the default
// world.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include <osgTerrainROAM/core/method/Method.h>

#include "HillsText.h"
#include "Playing.h"
#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

/// A georeferenced plain of 7 km with hills in the north.
std::string writePlain(const Workplace& place)
{
    (void)place.write("plain.prj",
                      "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
                      "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]");
    return place.write("plain.asc", hillsText());
}

bool tells(const ProgramRun& run, const char* words)
{
    return run.errors.find(words) != std::string::npos;
}

TEST(TourWorld, AWorldIsMadeUpOverARasterOnce)
{
    const Workplace place;
    const std::string plain = writePlain(place);
    const auto tour = [&](const std::string& name, std::vector<std::string> more)
    {
        std::vector<std::string> words{"tour",  plain,       "--frames",       "1",         "--size",
                                       "96x54", "--capture", place.path(name), "--samples", "1"};
        words.insert(words.end(), more.begin(), more.end());
        return runTrainer(words);
    };
    const std::vector<std::string> inFolder{"--world-folder", place.path("world")};
    const ProgramRun first = tour("first", inFolder), second = tour("second", inFolder);
    EXPECT_TRUE(succeeds(first));
    EXPECT_TRUE(succeeds(second));
    EXPECT_TRUE(tells(first, "makes up a world over")) << first.text();
    EXPECT_FALSE(tells(second, "makes up a world over")) << second.text();
    EXPECT_TRUE(bytesIn(place.path("first")) == bytesIn(place.path("second")));
    // The control: the elevation alone is another picture, and has no roads.
    EXPECT_TRUE(succeeds(tour("bare", {})));
    EXPECT_FALSE(bytesIn(place.path("first")) == bytesIn(place.path("bare")));
    EXPECT_TRUE(succeeds(tour("drive", {"--world-folder", place.path("world"), "--eye", "driver"})));
    EXPECT_TRUE(failsWith(tour("no-drive", {"--eye", "driver"}), 1, "trainer", {"no roads"}));
    // A file of the world that is damaged is made anew.
    (void)place.write("world/trees.gpkg", "damaged");
    EXPECT_TRUE(succeeds(tour("third", inFolder)));
    EXPECT_TRUE(bytesIn(place.path("first")) == bytesIn(place.path("third")));
}

TEST(TourWorld, WhereNoneCanBeMadeTheElevationIsShownAlone)
{
    const Workplace place;
    const ProgramRun run = runTrainer({"tour", place.hill(), "--world-folder", place.path("world"),
                                       "--frames", "1", "--size", "32x18", "--samples", "1"});
    EXPECT_TRUE(succeeds(run));
    EXPECT_TRUE(tells(run, "the elevation is shown alone")) << run.text();
    EXPECT_FALSE(std::filesystem::exists(place.path("world/world.roam")));
}

TEST(TourWorld, EveryMethodFliesOverARaster)
{
    const Workplace place;
    for (const auto& traits : osgTerrainROAM::core::kMethods)
    {
        const std::string name(traits.name);
        const ProgramRun run =
            runTrainer({"tour", writePlain(place), "--method", name, "--world-folder", place.path("world"),
                        "--frames", "1", "--size", "32x18", "--samples", "1"});
        EXPECT_TRUE(succeeds(run)) << name;
        EXPECT_EQ(tells(run, "takes no samples between those of the raster"), !traits.hasFineSamples)
            << run.text();
    }
}

TEST(TourWorld, FlightsAndDrivesUseTheDefaultWorldBesideTheProgram)
{
    const Workplace place;
    std::filesystem::create_directories(place.path("there/bin"));
    std::filesystem::copy_file(OSGTRAINER_TRAINER, place.path("there/bin/trainer"));
    const auto ride = [&](const char* kind, std::vector<std::string> more)
    {
        std::vector<std::string> words{place.path("there/bin/trainer"), kind, "--headless", "--duration",
                                       "2"};
        words.insert(words.end(), more.begin(), more.end());
        return runProgram(words);
    };
    const std::vector<std::string> car{"--vehicle", OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml"},
        aircraft{"--aircraft", OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml", "--start", "0,0,300,90,50"};
    EXPECT_TRUE(failsWith(ride("drive", car), 1, "trainer", {"default world", "default_world", "WORLD"}));
    EXPECT_TRUE(failsWith(ride("fly", aircraft), 1, "trainer", {"default world", "--no-world"}));
    const std::string world = place.path("there/data/world");
    ASSERT_TRUE(succeeds(runProgram({OSGTRAINER_WORLDTOOL, "build", writePlain(place), "--output", world})));
    const ProgramRun driven = ride("drive", car);
    EXPECT_TRUE(succeeds(driven));
    EXPECT_NE(driven.output.find("m of lanes"), std::string::npos) << driven.text();
    const ProgramRun flown = ride("fly", aircraft);
    EXPECT_TRUE(succeeds(flown));
    // The plain lies at 400 m and more; level ground at 0.
    EXPECT_EQ(flown.output.find(" 300.0 m high"), std::string::npos) << flown.text();
    EXPECT_TRUE(succeeds(ride("fly", {"--no-world", "--aircraft", aircraft[1], "--start", "0,0,300,90,50"})));
}

} // namespace
