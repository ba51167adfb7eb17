// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/earth/Airfields.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "RoughLand.h"
#include "worldmaking/check/LevelCheck.h"
#include "worldmaking/earth/EarthworkFile.h"

using osgTerrainROAM::core::Earthworks;
using roughland::inDegrees;
using roughland::kDegree;
using roughland::waving;
using worldmaking::LandMap;
using worldmaking::Runway;
using worldmaking::ShapeForm;

namespace
{

LandMap airfield(const worldmaking::Tags& runwayTags = {{"aeroway", "runway"}})
{
    LandMap map;
    map.shapes.push_back({1, ShapeForm::line, {inDegrees({{-500, 0}, {500, 0}})}, runwayTags});
    map.shapes.push_back(
        {2, ShapeForm::line, {inDegrees({{-100, 0}, {-100, 60}, {-100, 120}})}, {{"aeroway", "taxiway"}}});
    map.shapes.push_back({3,
                          ShapeForm::area,
                          {inDegrees({{-160, 100}, {-40, 100}, {-40, 180}, {-160, 180}})},
                          {{"aeroway", "apron"}}});
    return map;
}

Runway known(double fromX, double toX)
{
    Runway runway;
    runway.airport = "ABCD";
    runway.designators = "27/09";
    runway.from = glm::dvec2(fromX, 10.0) / kDegree;
    runway.to = glm::dvec2(toX, 10.0) / kDegree;
    runway.widthM = 18.0;
    runway.surface = "grass";
    return runway;
}

} // namespace

TEST(Airfields, ARunwayOfMapAndTableIsOne)
{
    const LandMap map = airfield();
    const auto plane = worldmaking::MapPlane::create(worldmaking::planeAbout(map), "made");
    ASSERT_TRUE(plane);
    const std::vector<Runway> table{known(480.0, -480.0), known(5000.0, 6000.0)};
    const auto runways = worldmaking::runwaysOf(map, *plane, table);
    ASSERT_EQ(runways.size(), 2u);
    EXPECT_EQ(runways[0].airport, "ABCD");
    EXPECT_EQ(runways[0].designators, "27/09");
    EXPECT_GT(runways[0].from.x, runways[0].to.x) << "in the direction of its designators";
    EXPECT_EQ(runways[0].widthM, 18.0);
    EXPECT_EQ(runways[0].surface, "grass");
    const auto told = worldmaking::runwaysOf(
        airfield({{"aeroway", "runway"}, {"ref", "09/27"}, {"width", "30"}, {"surface", "asphalt"}}), *plane,
        table);
    EXPECT_EQ(told[0].designators, "09/27");
    EXPECT_EQ(told[0].widthM, 30.0);
    EXPECT_EQ(told[0].surface, "asphalt") << "what the map says counts";
}

TEST(Airfields, ARunwayIsEvenAndItsTaxiwayAndApronMeetIt)
{
    const LandMap map = airfield();
    const auto plane = worldmaking::MapPlane::create(worldmaking::planeAbout(map), "made");
    ASSERT_TRUE(plane);
    const auto runways = worldmaking::runwaysOf(map, *plane, {});
    ASSERT_EQ(runways.size(), 1u);
    worldmaking::AirfieldReport report;
    const Earthworks works(worldmaking::airfieldWorks(map, runways, *plane, waving, report), 0.0, waving);
    EXPECT_EQ(report.runways, 1u);
    EXPECT_EQ(report.taxiways, 1u);
    EXPECT_EQ(report.aprons, 1u);
    EXPECT_EQ(report.steepRunways, 0u);
    const foundation::HeightInPlan after = [&](const glm::dvec2& place) -> std::optional<double>
    { return works.heightM(place, *waving(place)); };
    const auto from = plane->toPlan(runways[0].from), to = plane->toPlan(runways[0].to);
    const auto figures = worldmaking::runwayFigures(*from, *to, runways[0].widthM, after);
    EXPECT_TRUE(isEvenRunway(figures))
        << figures.slope << ' ' << figures.slopeChange << ' ' << figures.crossfall;
    EXPECT_FALSE(isEvenRunway(worldmaking::runwayFigures(*from, *to, runways[0].widthM, waving)));
    double before = *after(*plane->toPlan(glm::dvec2(-100.0, 0.0) / kDegree));
    for (double y = 1.0; y < 175.0; y += 1.0)
    {
        const double height = *after(*plane->toPlan(glm::dvec2(-100.0, y) / kDegree));
        EXPECT_LT(std::abs(height - before), 0.35) << "a step at " << y;
        before = height;
    }
}

TEST(Airfields, EarthworksAreWrittenTwiceAsTheSameBytes)
{
    const LandMap map = airfield();
    const auto plane = worldmaking::MapPlane::create(worldmaking::planeAbout(map), "made");
    worldmaking::AirfieldReport report;
    const auto works =
        worldmaking::airfieldWorks(map, worldmaking::runwaysOf(map, *plane, {}), *plane, waving, report);
    const auto folder = std::filesystem::temp_directory_path();
    std::string bytes[2];
    for (int i = 0; i < 2; ++i)
    {
        const auto file = folder / ("airfield-works-" + std::to_string(i) + ".gpkg");
        const auto written = worldmaking::writeEarthworks(works, *plane, file);
        ASSERT_TRUE(written) << written.error().message();
        std::ifstream stream(file, std::ios::binary);
        bytes[i].assign(std::istreambuf_iterator<char>(stream), {});
        std::filesystem::remove(file);
    }
    EXPECT_GT(bytes[0].size(), 1000u);
    EXPECT_TRUE(bytes[0] == bytes[1]);
}
