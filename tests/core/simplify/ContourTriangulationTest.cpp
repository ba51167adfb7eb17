// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include <osgPMObjects/core/simplify/ContourTriangulation.h>
#include <osgPMObjects/core/tessellate/Orientation.h>

#include "Random.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;
using Contour = std::vector<glm::dvec2>;

std::vector<Triangle> triangulated(const Contour& contour)
{
    std::vector<Triangle> triangles;
    EXPECT_TRUE(triangulateContour(contour, triangles));
    return triangles;
}

double twiceArea(const Contour& contour, const Triangle& t)
{
    return orientation(contour[t[0]], contour[t[1]], contour[t[2]]);
}

/// Returns a value above zero when p lies inside of the circle through the corners of a counter-clockwise
/// triangle.
double inCircle(const Contour& contour, const Triangle& t, const glm::dvec2& p)
{
    glm::dmat3 rows;
    for (int i = 0; i < 3; ++i)
    {
        const glm::dvec2 d = contour[t[i]] - p;
        rows[i] = {d.x, d.y, glm::dot(d, d)};
    }
    return glm::determinant(rows);
}

/// Whether the triangles are the constrained Delaunay triangulation of the contour: exchanging an inner edge
/// for the other diagonal of its two triangles never makes their smallest angle larger.
bool isDelaunay(const Contour& contour, const std::vector<Triangle>& triangles)
{
    if (triangles.size() != contour.size() - 2) return false;
    double area = 0.0, whole = 0.0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> opposite; // by side: the third corner
    for (const Triangle& t : triangles)
    {
        if (!(twiceArea(contour, t) > 0.0)) return false;
        area += twiceArea(contour, t);
        for (int c = 0; c < 3; ++c)
            if (!opposite.try_emplace({t[c], t[(c + 1) % 3]}, t[(c + 2) % 3]).second) return false;
    }
    for (std::size_t i = 0; i < contour.size(); ++i)
        whole += orientation({0.0, 0.0}, contour[i], contour[(i + 1) % contour.size()]);
    if (std::abs(area - whole) > 1e-9 * whole) return false;
    for (const auto& [side, third] : opposite)
    {
        const auto back = opposite.find({side.second, side.first});
        if (back != opposite.end() &&
            inCircle(contour, {side.first, side.second, third}, contour[back->second]) > 1e-9)
            return false;
    }
    return true;
}

/// A simple contour: corners in turn around the origin, at any distance from it.
Contour starShaped(Random& random)
{
    const std::size_t count = 3 + random.below(13);
    std::vector<double> turns;
    while (turns.size() < count)
        turns.push_back(2.0 * std::numbers::pi * (static_cast<double>(turns.size()) + 0.8 * random.unit()) /
                        static_cast<double>(count));
    Contour contour;
    for (const double turn : turns)
        contour.emplace_back((0.2 + 0.8 * random.unit()) * glm::dvec2(std::cos(turn), std::sin(turn)));
    return contour;
}

TEST(ContourTriangulation, TheCornerUnderTheLargestAngleIsTaken)
{
    // Base line from (0, 3) to (0, 0): its angle is 113 degrees at (1, 1.5), 32 at (5, 0.1) and (5, 2.9).
    const Contour contour = {{0, 0}, {5, 0.1}, {1, 1.5}, {5, 2.9}, {0, 3}};
    const auto triangles = triangulated(contour);
    EXPECT_EQ(triangles.front(), (Triangle{0, 2, 4}));
    EXPECT_TRUE(isDelaunay(contour, triangles));
}

TEST(ContourTriangulation, AHiddenCornerIsNotTaken)
{
    // A U with narrow arms. The angle of the base line from (0, 10) to (0, 0) is 153 degrees at (1.2, 5),
    // across the gap between the arms; in its own arm it is 84 degrees at (1, 10).
    const Contour arms = {{0, 0},   {0, -21},   {2, -21}, {2, 10}, {1.3, 10},
                          {1.2, 5}, {1.3, -20}, {1, -20}, {1, 10}, {0, 10}};
    const auto triangles = triangulated(arms);
    EXPECT_EQ(triangles.front(), (Triangle{0, 8, 9}));
    EXPECT_TRUE(isDelaunay(arms, triangles));
}

TEST(ContourTriangulation, CornersOnAStraightSideMakeNoFlatTriangle)
{
    const Contour square = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    EXPECT_TRUE(isDelaunay(square, triangulated(square)));
    const Contour side = {{0, 0}, {1, 0}, {2, 0}, {1, 3}};
    EXPECT_TRUE(isDelaunay(side, triangulated(side)));
}

TEST(ContourTriangulation, TenThousandContoursByChanceAreDelaunay)
{
    Random random(4);
    for (int round = 0; round < 10000; ++round)
    {
        const Contour contour = starShaped(random);
        if (!isSimpleContour(contour)) continue; // flatter than the tolerance, or clockwise around the origin
        ASSERT_TRUE(isDelaunay(contour, triangulated(contour))) << "round " << round;
    }
}

TEST(ContourTriangulation, TheCheckSeesAWrongDiagonal)
{
    const Contour kite = {{0, 0}, {5, -1}, {10, 0}, {5, 1}};
    EXPECT_TRUE(isDelaunay(kite, {{0, 1, 3}, {1, 2, 3}}));
    EXPECT_FALSE(isDelaunay(kite, {{0, 1, 2}, {0, 2, 3}}));
    EXPECT_FALSE(isDelaunay(kite, {{0, 1, 3}, {1, 3, 2}}));
    EXPECT_FALSE(isDelaunay(kite, {{0, 1, 3}}));
}

TEST(ContourTriangulation, WhatIsNoSimpleContourIsRefused)
{
    const std::map<std::string, Contour> contours = {
        {"bow-tie", {{0, 0}, {2, 2}, {2, 0}, {0, 2}}},
        {"clockwise", {{0, 0}, {0, 1}, {1, 1}, {1, 0}}},
        {"two corners at one place", {{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}},
        {"a spike", {{0, 0}, {3, 0}, {2, 0}, {2, 2}}},
        {"a corner on another side", {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}},
        {"flat", {{0, 0}, {1, 0}, {2, 0}}},
        {"two corners", {{0, 0}, {1, 0}}},
        {"nothing", {}}};
    for (const auto& [name, contour] : contours)
    {
        std::vector<Triangle> triangles = {{7, 8, 9}};
        EXPECT_FALSE(isSimpleContour(contour)) << name;
        EXPECT_FALSE(triangulateContour(contour, triangles)) << name;
        EXPECT_EQ(triangles.size(), 1u) << name;
    }
}

TEST(ContourTriangulation, TooManyCornersAreRefused)
{
    for (const std::size_t count : {kMostContourCorners, kMostContourCorners + 1})
    {
        Contour contour;
        for (std::size_t i = 0; i < count; ++i)
        {
            const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
            contour.emplace_back(std::cos(turn), std::sin(turn));
        }
        std::vector<Triangle> triangles;
        EXPECT_EQ(triangulateContour(contour, triangles), count <= kMostContourCorners);
    }
}

} // namespace
