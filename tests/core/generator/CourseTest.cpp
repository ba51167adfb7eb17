// SPDX-License-Identifier: Apache-2.0
// The course of roads: closed, gentle, smooth, and read by the reader of OpenDRIVE without a word.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/read/ReadNetwork.h>

#include "course/CourseFile.h"
#include "course/CourseRoad.h"
#include "course/CourseSearch.h"

namespace islandgen
{
namespace
{

/// A quarter of the default terrain's samples; the large forms are the same.
const Terrain& land()
{
    static const Terrain kLand = std::move(generateTerrain(kDefaultSeed, 257).value());
    return kLand;
}

const Alignment& course()
{
    static const Alignment kCourse = *searchCourse(land(), {1700.0, -900.0}, 1);
    return kCourse;
}

double endGapM(const Alignment& alignment)
{
    const auto line = alignment.line();
    return glm::length(line.at(alignment.lengthM).position - line.at(0.0).position);
}

double steepest(const osgRoads::core::CubicProfile& profile, double lengthM)
{
    double steepestGrade = 0.0;
    for (double s = 0.0; s < lengthM; s += 1.0)
        steepestGrade = std::max(steepestGrade, std::abs(profile.slope(s)));
    return steepestGrade;
}

/// The largest step of curvature between elements, 1/m.
double curvatureStep(const Alignment& alignment)
{
    double step = 0.0;
    for (std::size_t i = 0; i < alignment.elements.size(); ++i)
    {
        const auto& before = alignment.elements[i];
        const auto& after = alignment.elements[(i + 1) % alignment.elements.size()];
        step = std::max(step, std::abs(before.at(before.length).curvature - after.at(0.0).curvature));
    }
    return step;
}

TEST(Course, isClosedAndLongEnough)
{
    EXPECT_GE(course().lengthM, 6000.0);
    EXPECT_LT(endGapM(course()), 1e-6);
    EXPECT_LT(curvatureStep(course()), 1e-9);
}

TEST(Course, gradesAreFeasible)
{
    const CourseHeights heights = courseHeights(land(), course(), 5.0, 100.0);
    EXPECT_LT(steepest(profileOf(heights, 0.0), course().lengthM), 1.1 * kSteepestGrade);
    for (const double heightM : heights.roadM)
        EXPECT_GE(heightM, 2.5);
}

TEST(Course, mutationsAreSeen)
{
    Alignment open = course();
    open.elements[4] = {open.elements[4].s, open.elements[4].length + 0.01, open.elements[4].at(0.0).position,
                        open.elements[4].at(0.0).headingRad + 0.01, open.elements[4].shape()};
    open.elements.back() = {open.elements.back().s, open.elements.back().length,
                            open.elements.back().at(0.0).position + glm::dvec2(0.01, 0.0),
                            open.elements.back().at(0.0).headingRad, osgRoads::core::LineShape{}};
    EXPECT_GT(endGapM(open), 1e-3);
    EXPECT_GT(curvatureStep(open), 1e-4);
    CourseHeights steep = courseHeights(land(), course(), 5.0, 100.0);
    for (std::size_t i = 100; i < 110; ++i)
        steep.roadM[i] += 8.0;
    EXPECT_GT(steepest(profileOf(steep, 0.0), course().lengthM), 1.1 * kSteepestGrade);
}

/// The lengths of all tunnels of the course on some land.
double tunnelsM(const Terrain& terrain, const CourseHeights& heights)
{
    double sum = 0.0;
    for (const CourseRoad& road : roadsOf(terrain, course(), heights))
        for (const Stretch& tunnel : road.tunnels)
            sum += tunnel.toM - tunnel.fromM;
    return sum;
}

/// The land with a hill on the course at s.
Terrain withHill(double s, double heightM)
{
    Terrain terrain = land();
    const glm::dvec2 place = course().line().at(s).position;
    const int side = terrain.heightM.side;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
        {
            const glm::dvec2 at = double(terrain.cellM) * (glm::dvec2(column, row) - 0.5 * (side - 1));
            const double away = glm::length(at - place) / 150.0;
            terrain.heightM.at(column, row) += static_cast<float>(heightM * std::exp(-0.5 * away * away));
        }
    return terrain;
}

TEST(Course, aHillIsRunThroughByATunnelAndAHeapIsNot)
{
    const CourseHeights heights = courseHeights(land(), course(), 5.0, 100.0);
    const double without = tunnelsM(land(), heights), s = 0.5 * course().lengthM;
    // 50 · exp(-(x/150)²/2) is 8 m at x = 287 m.
    EXPECT_NEAR(tunnelsM(withHill(s, 50.0), heights) - without, 2.0 * 287.0, 200.0);
    EXPECT_NEAR(tunnelsM(withHill(s, 4.0), heights), without, 40.0);
}

TEST(Course, isReadWithoutAWord)
{
    const auto file = std::filesystem::path(testing::TempDir()) / "course.xodr";
    const CourseHeights heights = courseHeights(land(), course(), 5.0, 100.0);
    ASSERT_TRUE(writeCourse(land(), course(), heights, file));
    const auto read = osgRoads::core::readNetwork(file);
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->problems.empty());
    ASSERT_EQ(read->network.roads.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
    {
        const osgRoads::core::Road& road = read->network.roads[i];
        const osgRoads::core::Road& next = read->network.roads[(i + 1) % 4];
        const glm::dvec3 end = osgRoads::core::surfacePoint(road, road.length, -3.0);
        EXPECT_LT(glm::length(end - osgRoads::core::surfacePoint(next, 0.0, -3.0)), 1e-3);
        EXPECT_GE(road.signals.size(), 2u);
        EXPECT_GE(road.objects.size(), 2u);
    }
    std::filesystem::remove(file);
}

TEST(Course, aLandTooSmallHasNone)
{
    EXPECT_FALSE(alignmentOf({{0.0, 0.0}, {100.0, 0.0}, {100.0, 100.0}, {0.0, 100.0}}));
}

} // namespace
} // namespace islandgen
