// SPDX-License-Identifier: Apache-2.0
// A car on a road and an aircraft on a GeoPosition trajectory in one storyboard, over the default terrain and over a real one.
#include <iomanip>
#include <regex>
#include <sstream>

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

/// The pictures that a scenario gives from the car and from behind the aircraft; the aircraft is in the latter.
void expectBothEyes(const Workplace& place, const std::string& scenario)
{
    ASSERT_TRUE(succeeds(runTrainer({"check", scenario})));
    const Playing driver = playedAs(place, "driver", {"play", scenario}, {"--frames", "2", "--fps", "1"});
    const Playing chase =
        playedAs(place, "chase", {"play", scenario},
                 {"--frames", "2", "--fps", "1", "--eye", "chase", "--eye-entity", "aircraft"});
    ASSERT_EQ(driver.frames.size(), 2U);
    ASSERT_EQ(chase.frames.size(), 2U);
    EXPECT_NE(driver.frames, chase.frames);
    EXPECT_NE(chase.frames.at("frame_00000.png"), chase.frames.at("frame_00001.png")) << "nothing moves";
}

TEST(DriveAndFlight, PlaysOverTheDefaultTerrain)
{
    expectBothEyes(Workplace(), kScenario);
}

TEST(DriveAndFlight, PlaysOverARealTerrain)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(dem, "dem/N44W072.hgt");
    const Workplace place;
    expectBothEyes(place,
                   place.write("moved.xosc", movedTo(readBytes(kScenario), 0.70, -79.75, dem.string())));
}

} // namespace
