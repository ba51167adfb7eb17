// SPDX-License-Identifier: Apache-2.0
// A car on a road and an aircraft on a GeoPosition trajectory in one storyboard, over the default terrain and
// over a real one.
#include <iomanip>
#include <regex>
#include <sstream>

#include <gdal_priv.h>
#include <gdal_utils.h>

#include "Playing.h"
#include "RealData.h"

namespace
{

const std::string kScenario = std::string(OSGTRAINER_SOURCE_DIR) + "/data/scenarios/drive-and-flight.xosc";

/// The same storyboard elsewhere on earth, over the ground of a raster instead of the road.
std::string movedTo(const std::string& text, double northDeg, double eastDeg, const std::string& raster)
{
    static const std::regex place("latitudeDeg=\"([-0-9.]+)\" longitudeDeg=\"([-0-9.]+)\"");
    static const std::regex roads("<RoadNetwork>[^]*</RoadNetwork>");
    std::ostringstream moved;
    moved << std::setprecision(12);
    auto at = text.begin();
    for (std::sregex_iterator found(text.begin(), text.end(), place), end; found != end; ++found)
    {
        moved << std::string(at, (*found)[0].first) << "latitudeDeg=\"" << std::stod((*found)[1]) + northDeg
              << "\" longitudeDeg=\"" << std::stod((*found)[2]) + eastDeg << '"';
        at = (*found)[0].second;
    }
    moved << std::string(at, text.end());
    return std::regex_replace(moved.str(), roads,
                              "<RoadNetwork><SceneGraphFile filepath=\"" + raster + "\" /></RoadNetwork>");
}

/// The part of a raster about the storyboard, moved by so many degrees: some 10 km each way open quickly.
std::string partOf(const Workplace& place, const std::string& raster, double northDeg, double eastDeg)
{
    constexpr double kReachDeg = 0.05;
    const double north = 43.5991 + northDeg, east = 8.2249 + eastDeg;
    std::vector<std::string> words{"-projwin_srs",
                                   "EPSG:4326",
                                   "-projwin",
                                   std::to_string(east - kReachDeg),
                                   std::to_string(north + kReachDeg),
                                   std::to_string(east + kReachDeg),
                                   std::to_string(north - kReachDeg)};
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    GDALAllRegister();
    const std::string part = place.path("part.tif");
    GDALDataset* const whole = GDALDataset::FromHandle(GDALOpen(raster.c_str(), GA_ReadOnly));
    GDALTranslateOptions* const options = GDALTranslateOptionsNew(arguments.data(), nullptr);
    const GDALDatasetH made = GDALTranslate(part.c_str(), whole, options, nullptr);
    EXPECT_TRUE(made) << raster;
    GDALTranslateOptionsFree(options);
    GDALClose(made);
    GDALClose(whole);
    return part;
}

/// From behind the aircraft: it moves.
Playing expectChase(const Workplace& place, const std::string& scenario)
{
    Playing chase = playedAs(place, "chase", {"play", scenario},
                             {"--frames", "2", "--fps", "1", "--eye", "chase", "--eye-entity", "aircraft"});
    EXPECT_EQ(chase.frames.size(), 2U);
    EXPECT_NE(chase.frames["frame_00000.png"], chase.frames["frame_00001.png"]) << "nothing moves";
    return chase;
}

/// From the driver's seat.
Playing expectDriver(const Workplace& place, const std::string& scenario)
{
    EXPECT_TRUE(succeeds(runTrainer({"check", scenario})));
    Playing driver = playedAs(place, "driver", {"play", scenario}, {"--frames", "1", "--fps", "1"});
    EXPECT_EQ(driver.frames.size(), 1U);
    return driver;
}

/// The scenario as it is, with its road, from the car; the flight over the part of the terrain below it.
TEST(DriveAndFlight, PlaysOverTheDefaultTerrain)
{
    const Workplace place;
    const std::string part =
        partOf(place, std::string(OSGTRAINER_SOURCE_DIR) + "/build/data/default_terrain.tif", 0.0, 0.0);
    const auto driver = expectDriver(place, kScenario);
    const auto chase =
        expectChase(place, place.write("above.xosc", movedTo(readBytes(kScenario), 0.0, 0.0, part)));
    EXPECT_NE(driver.frames, chase.frames);
}

TEST(DriveAndFlight, PlaysOverARealTerrain)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(dem, "dem/N44W072.hgt");
    const Workplace place;
    const std::string part = partOf(place, dem.string(), 0.70, -79.75);
    const std::string moved = place.write("moved.xosc", movedTo(readBytes(kScenario), 0.70, -79.75, part));
    EXPECT_NE(expectDriver(place, moved).frames, expectChase(place, moved).frames);
}

} // namespace
