// SPDX-License-Identifier: Apache-2.0
// What stands in a world, by the three selections of Sadykov and Zakharov (2002): parked vehicles by the
// continuous rule with geomorph, houses by overlapping ranges, trees by a budget. A car drives towards them;
// each golden is the fifth frame. Written anew with those of the trainer (-R TrainerGolden).
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include <glm/vec2.hpp>

#include <osgOffscreen/OffscreenContext>
#include <osgOffscreen/PngFile>

#include "ProgramRun.h"
#include "RenderedGolden.h"
#include "Workplace.h"

namespace
{

/// A place ahead of the car: metres along its way and to the left of it, in the CRS of the hill.
glm::dvec2 aheadOf(double alongM, double leftM)
{
    return glm::dvec2(436375.0, 4828875.0) + alongM * glm::dvec2(0.866, 0.5) +
           leftM * glm::dvec2(-0.5, 0.866);
}

/// Features of a GeoJSON file.
class Features
{
public:
    void point(const glm::dvec2& at, const std::string& properties)
    {
        add("Point", "[" + place(at) + "]", properties);
    }

    void rectangle(double alongM, double leftM, double lengthM, double widthM, const std::string& properties)
    {
        std::string ring;
        for (const auto& [a, b] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}, {0, 0}})
            ring +=
                (ring.empty() ? "[" : ",[") + place(aheadOf(alongM + a * lengthM, leftM + b * widthM)) + "]";
        add("Polygon", "[[" + ring + "]]", properties);
    }

    std::string text() const
    {
        return R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32632"}}, "features": [)" +
               _features + "]}";
    }

private:
    static std::string place(const glm::dvec2& at)
    {
        return std::to_string(at.x) + "," + std::to_string(at.y);
    }
    void add(const std::string& kind, const std::string& coordinates, const std::string& properties)
    {
        _features += (_features.empty() ? "" : ",\n") +
                     (R"({"type": "Feature", "properties": {)" + properties) +
                     R"(}, "geometry": {"type": ")" + kind + R"(", "coordinates": )" + coordinates + "}}";
    }

    std::string _features;
};

std::string vehicles(double movedM)
{
    Features made;
    int number = 0;
    for (double along = 40.0; along < 260.0; along += 8.0)
        for (const double left : {-6.0, 6.0})
        {
            ++number;
            made.point(aheadOf(along + movedM, left),
                       R"("kind": ")" + std::string(number % 5 == 0 ? "van" : "saloon") +
                           R"(", "heading": ")" + std::to_string(53 * number % 360) + "\"");
        }
    return made.text();
}

std::string houses(double movedM)
{
    Features made;
    int number = 0;
    for (double along = 40.0; along < 420.0; along += 26.0)
        for (const double left : {-26.0, 15.0})
            made.rectangle(along + movedM, left, 12.0, 9.0,
                           R"("building": "house", "building:levels": "2", "id": ")" +
                               std::to_string(++number) + "\"");
    return made.text();
}

std::string trees(double movedM)
{
    Features made;
    int number = 0;
    for (double along = 40.0; along < 400.0; along += 7.0)
        for (double left = -60.0; left <= 60.0; left += 7.0)
            if (std::abs(left) > 5.0)
                made.point(aheadOf(along + movedM + 2.0 * std::sin(left), left),
                           R"("kind": ")" + std::string(++number % 3 == 0 ? "spruce" : "oak") + "\"");
    return made.text();
}

std::string timedAt(const std::string& position, int seconds)
{
    return simulation::vertex("<WorldPosition " + position + "/>", std::to_string(seconds));
}

/// A car drives over the hill's foot for four seconds.
std::string pastThingsText()
{
    simulation::ScenarioText text;
    text.privates = simulation::followTrajectory(
        timedAt("x=\"-600\" y=\"-100\"", 0) + timedAt("x=\"-588\" y=\"-93\"", 1) +
            timedAt("x=\"-576\" y=\"-86\"", 2) + timedAt("x=\"-562\" y=\"-78\"", 4),
        simulation::kTiming, "follow");
    text.stop = simulation::stopAt(4.0);
    return with(text.text(), "<RoadNetwork/>",
                "<RoadNetwork><SceneGraphFile filepath=\"world.roam\"/></RoadNetwork>");
}

/// Draws a world and compares the fifth frame.
testing::AssertionResult looksAs(const std::string& golden, const std::string& key, const std::string& things)
{
    const Workplace place;
    place.write("things.geojson", things);
    place.write("world.roam", "dem = hill.tif\n" + key + " = things.geojson\n");
    const std::string folder = place.path("frames");
    const ProgramRun run =
        runTrainer({"play", place.write("drive.xosc", pastThingsText()), "--eye", "chase", "--fps", "3",
                    "--size", "240x135", "--frames", "5", "--capture", folder});
    if (run.exitCode != 0) return testing::AssertionFailure() << run.text();
    const auto image = osgOffscreen::readPng(folder + "/frame_00004.png");
    if (!image) return testing::AssertionFailure() << image.error().message();
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = settings.heightPx = 16;
    const auto context = osgOffscreen::OffscreenContext::create(settings);
    return rendered::matchesGolden(**image, golden, context ? (*context)->rendererName() : "");
}

/// The golden, and the control: the same things 30 cm farther on.
void expectGolden(const std::string& golden, const std::string& key,
                  const std::function<std::string(double movedM)>& things)
{
    EXPECT_TRUE(looksAs(golden, key, things(0.0)));
    if (rendered::writesGoldens()) return;
    EXPECT_FALSE(looksAs(golden, key, things(0.3)));
}

} // namespace

TEST(TrainerGoldenWorld, ParkedVehiclesByTheContinuousRule)
{
    expectGolden("world-vehicles", "objects", vehicles);
}

TEST(TrainerGoldenWorld, HousesByOverlappingRanges)
{
    expectGolden("world-houses", "buildings", houses);
}

TEST(TrainerGoldenWorld, TreesByBudget)
{
    expectGolden("world-trees", "objects", trees);
}
