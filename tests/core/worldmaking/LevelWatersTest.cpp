// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/earth/LevelWaters.h"

#include <gtest/gtest.h>

#include <osgRoads/core/read/ReadNetwork.h>

#include "RoughLand.h"
#include "scenery/buildings/Outline.h"
#include "worldmaking/check/LevelCheck.h"

using osgTerrainROAM::core::Earthwork;
using roughland::inDegrees;
using worldmaking::LandMap;
using worldmaking::MapPlane;
using worldmaking::PlanRings;
using worldmaking::ShapeForm;

namespace
{

/// A river of 40 m by 400 m along the equator, and a lake north of it.
LandMap riverAndLake()
{
    LandMap map;
    map.shapes.push_back({1,
                          ShapeForm::area,
                          {inDegrees({{0, -20}, {400, -20}, {400, 20}, {0, 20}})},
                          {{"natural", "water"}, {"water", "river"}}});
    map.shapes.push_back({2,
                          ShapeForm::area,
                          {inDegrees({{0, 100}, {400, 100}, {400, 300}, {0, 300}})},
                          {{"natural", "water"}}});
    map.shapes.push_back({3, ShapeForm::line, {inDegrees({{0, 500}, {400, 500}})}, {{"waterway", "stream"}}});
    return map;
}

/// A straight road of two lanes of 3.5 m, from (0, y) 400 m to the east, on a bridge from 300 m on.
osgRoads::core::RoadNetwork roadAt(double y)
{
    const std::string lane = R"(<width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane>)";
    const std::string text =
        R"(<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="400" junction="-1">
<planView><geometry s="0" x="0" y=")" +
        std::to_string(y) + R"(" hdg="0" length="400"><line/></geometry></planView>
<lanes><laneSection s="0"><left><lane id="1" type="driving" level="false">)" +
        lane + R"(</left><center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false">)" +
        lane + R"(</right></laneSection></lanes>
<objects><bridge id="b" type="concrete" s="300" length="100"/></objects></road></OpenDRIVE>)";
    auto read = osgRoads::core::parseNetwork(text, "river.xodr");
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    return std::move(read->network);
}

MapPlane planeAtZero()
{
    osgRoads::core::NetworkHeader header;
    header.geoReference = "+proj=tmerc +lat_0=0 +lon_0=0 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs";
    return *MapPlane::create(header, "made");
}

/// A bed along the middle of the river.
Earthwork bed(double widthM)
{
    Earthwork work;
    work.paths = {{{-10.0, 0.0}, {410.0, 0.0}}};
    work.heightsM = {{10.0, 10.0}};
    work.widthM = widthM;
    work.river = 1;
    return work;
}

double areaM2(const LandMap& map, std::int64_t id, const MapPlane& plane)
{
    double sum = 0.0;
    for (const auto& shape : map.shapes)
        if (shape.id == id) sum += scenery::areaOf(*plane.toPlan(shape.paths));
    return sum;
}

} // namespace

TEST(LevelWaters, ARiverIsCutToItsBedAndALakeIsNot)
{
    const MapPlane plane = planeAtZero();
    LandMap map = riverAndLake();
    const double lakeM2 = areaM2(map, 2, plane);
    const std::vector<Earthwork> works{bed(22.0)};
    EXPECT_EQ(worldmaking::cutToLevel(map, plane, works, {}), 0u);
    EXPECT_NEAR(areaM2(map, 1, plane), 400.0 * 20.0, 80.0) << "the bed less a metre on either side";
    EXPECT_DOUBLE_EQ(areaM2(map, 2, plane), lakeM2);
    EXPECT_EQ(map.shapes.back().id, 3) << "streams stay";
}

TEST(LevelWaters, WaterKeepsOffTheGroundOfRoadsButGoesUnderBridges)
{
    const MapPlane plane = planeAtZero();
    LandMap map = riverAndLake();
    worldmaking::cutToLevel(map, plane, {}, roadAt(0.0));
    // 300 m and a sample of 16 m are gone from the middle; what lies beside it and below the bridge is left.
    EXPECT_NEAR(areaM2(map, 1, plane), 400.0 * 40.0 - 305.0 * 16.0, 200.0);
    LandMap drained = riverAndLake();
    auto wide = roadAt(0.0);
    wide.roads[0].structures.clear();
    const std::vector<Earthwork> narrow{bed(10.0)};
    EXPECT_EQ(worldmaking::cutToLevel(drained, plane, narrow, wide), 1u) << "the road covers the whole bed";
}

TEST(LevelCheck, ARiverMayFallAlongItsCourseAlone)
{
    const PlanRings river{{{0, -20}, {400, -20}, {400, 20}, {0, 20}}};
    const PlanRings course{{{0, 0}, {200, 0}, {400, 0}}};
    const auto isEven = [&](const PlanRings& courses, auto height)
    {
        return worldmaking::isEvenWater(worldmaking::waterFigures(
            river, courses, [=](const glm::dvec2& place) -> std::optional<double> { return height(place); }));
    };
    const auto rapid = [](const glm::dvec2& place)
    { return 100.0 - 0.3 * place.x + std::abs(place.y) * 0.01; };
    EXPECT_TRUE(isEven(course, rapid));
    EXPECT_FALSE(isEven({}, rapid)) << "a lake does not fall";
    EXPECT_FALSE(isEven(course, [&](const glm::dvec2& place) { return -rapid(place); })) << "upwards";
    EXPECT_FALSE(isEven(course, [&](const glm::dvec2& place) { return rapid(place) + 0.2 * place.y; }))
        << "across";
    EXPECT_FALSE(isEven(course, [](const glm::dvec2& place) { return place.x < 200.0 ? 50.0 : 20.0; }))
        << "a step";
}

TEST(LevelCheck, ARiverHasNoShoreWhereItGoesOnAndOneBesideIt)
{
    const worldmaking::PlanRings piece{{{0, -5}, {20, -5}, {20, 5}, {0, 5}}},
        course{{{-100, 0}, {10, 0}, {120, 0}}};
    const auto figures = [&](double bankM, const worldmaking::PlanRings& courses)
    {
        return worldmaking::waterFigures(piece, courses,
                                         [=](const glm::dvec2& place) -> std::optional<double> {
                                             return 100.0 - 0.1 * place.x +
                                                    (std::abs(place.y) > 7.0 ? bankM : 0.0);
                                         });
    };
    EXPECT_EQ(figures(1.0, course).lowShore, 0.0) << "it falls out of its piece";
    EXPECT_GT(figures(1.0, {}).lowShore, 0.1) << "a lake does not";
    EXPECT_GT(figures(-1.0, course).lowShore, 0.9) << "banks that are too low are found";
    EXPECT_FALSE(worldmaking::isEvenWater(figures(-1.0, course)));
}
