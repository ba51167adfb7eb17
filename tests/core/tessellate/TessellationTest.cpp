// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgPMObjects/core/tessellate/Tessellation.h>

#include "TriangulationCheck.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Polygon;
using testsupport::Random;

/// A polygon's outline and triangles, in the plane that it was projected to.
struct Cut
{
    PolygonOutline outline;
    std::vector<Triangle> triangles;
    std::string defect;
};

Polygon inPlaneOf(const PolygonOutline& outline, const Polygon& polygon)
{
    Polygon moved = polygon;
    std::copy_n(outline.points.begin(), moved.corners.size(), moved.corners.begin());
    return moved;
}

Cut cut(const Polygon& polygon, InsideRule rule = InsideRule::odd)
{
    Cut made;
    auto outline = outlinePolygon(polygon.inSpace(), polygon.contourSizes, {.inside = rule});
    if (!outline)
    {
        made.defect = outline.error().message();
        return made;
    }
    made.outline = *outline;
    for (const Loop& loop : outline->loops)
    {
        const auto triangles = clipEars(outline->points, loop);
        if (!triangles)
        {
            made.defect = "a loop has no ear";
            return made;
        }
        made.triangles.insert(made.triangles.end(), triangles->begin(), triangles->end());
    }
    const double area =
        testsupport::areaWhere(inPlaneOf(*outline, polygon), [rule](int number)
                               { return rule == InsideRule::odd ? number % 2 != 0 : number != 0; });
    made.defect = testsupport::defectOf(outline->points, made.triangles, area);
    if (made.defect.empty() && testsupport::hasTJunction(outline->points, made.triangles))
        made.defect = "a T-junction";
    return made;
}

std::string text(const Polygon& polygon)
{
    std::string all;
    std::size_t corner = 0;
    for (const std::uint32_t size : polygon.contourSizes)
    {
        all += "contour";
        for (std::uint32_t i = 0; i < size; ++i, ++corner)
            all += " (" + std::to_string(polygon.corners[corner].x) + ", " +
                   std::to_string(polygon.corners[corner].y) + ")";
        all += "\n";
    }
    return all;
}

Polygon polygon(std::initializer_list<std::vector<glm::dvec2>> contours)
{
    Polygon made;
    for (const auto& contour : contours)
        made.add(contour);
    return made;
}

TEST(Tessellation, OfASquareIsTwoTriangles)
{
    const std::vector<glm::dvec3> corners = {{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}};
    const std::uint32_t size = 4;
    const auto made = tessellate(corners, std::span(&size, 1));
    ASSERT_TRUE(made);
    ASSERT_EQ(made->triangles.size(), 2u);
    for (const Triangle& t : made->triangles)
        EXPECT_GT(glm::cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]).z, 0.0);
}

TEST(Tessellation, KeepsTheDirectionOfThePolygonInEveryPlane)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0})
        {
            std::vector<glm::dvec3> corners;
            for (const glm::dvec2 p : {glm::dvec2(0, 0), {4, 0}, {4, 4}, {2, 1}, {0, 4}})
            {
                glm::dvec3 corner(0.0);
                corner[(axis + 1) % 3] = p.x;
                corner[(axis + 2) % 3] = side * p.y;
                corner[axis] = 0.25 * p.x;
                corners.push_back(corner);
            }
            const std::uint32_t size = 5;
            for (const ProjectionRule rule : {ProjectionRule::largestArea, ProjectionRule::averageNormal})
            {
                const auto made = tessellate(corners, std::span(&size, 1), {.projection = rule});
                ASSERT_TRUE(made);
                ASSERT_EQ(made->triangles.size(), 3u);
                glm::dvec3 sum(0.0);
                for (const Triangle& t : made->triangles)
                {
                    const glm::dvec3 area =
                        glm::cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]);
                    EXPECT_GT(glm::dot(area, areaVector(corners)), 0.0);
                    sum += area;
                }
                EXPECT_LT(glm::length(sum - areaVector(corners)), 1e-12);
            }
        }
}

TEST(Tessellation, OfABowTieInsertsItsCrossing)
{
    const Polygon bowTie = polygon({{{0, 0}, {4, 2}, {4, 0}, {0, 2}}});
    const auto made = tessellate(bowTie.inSpace(), bowTie.contourSizes);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->crossings, 1u);
    ASSERT_EQ(made->inserted.size(), 1u);
    EXPECT_EQ(made->triangles.size(), 2u);
    const glm::dvec3 crossing = positionOf(made->inserted[0], bowTie.inSpace());
    EXPECT_LT(glm::distance(crossing, glm::dvec3(2, 1, 0)), 1e-12);
    EXPECT_EQ(cut(bowTie).defect, "");
}

TEST(Tessellation, OfAWarpedQuadTakesTheAverageNormalWhereAxesMakeABowTie)
{
    // Crosses itself seen along z, the axis of its largest area, but not along its average normal.
    Random random(3);
    int found = 0;
    for (int i = 0; i < 20000; ++i)
    {
        std::vector<glm::dvec3> quad(4);
        for (glm::dvec3& corner : quad)
            corner = {random.unit(), random.unit(), random.unit()};
        const std::uint32_t size = 4;
        const auto flat =
            outlinePolygon(quad, std::span(&size, 1), {.projection = ProjectionRule::largestArea});
        const auto both = outlinePolygon(quad, std::span(&size, 1));
        ASSERT_TRUE(flat);
        ASSERT_TRUE(both);
        EXPECT_LE(both->crossings, flat->crossings);
        found += both->crossings < flat->crossings && both->isAlongAverageNormal;
    }
    EXPECT_GT(found, 10);
}

TEST(Tessellation, OfNastyPolygonsIsRight)
{
    const std::vector<std::pair<const char*, Polygon>> nasty = {
        {"nothing", polygon({})},
        {"an empty contour", polygon({{}, {{0, 0}, {1, 0}, {0, 1}}, {}})},
        {"a point", polygon({{{1, 1}}})},
        {"a line there and back", polygon({{{0, 0}, {1, 1}}})},
        {"one place only", polygon({{{1, 1}, {1, 1}, {1, 1}, {1, 1}}})},
        {"a collinear run", polygon({{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 0}}})},
        {"duplicate points", polygon({{{0, 0}, {0, 0}, {4, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}, {0, 0}}})},
        {"a spike outwards", polygon({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 9}, {2, 4}, {0, 4}}})},
        {"a spike inwards", polygon({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 1}, {2, 4}, {0, 4}}})},
        {"a spike across", polygon({{{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, -3}, {2, 4}, {0, 4}}})},
        {"points along edges", polygon({{{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 1}, {4, 4}, {3, 4}, {0, 4}}})},
        {"touching itself in a point",
         polygon({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, {{1, 5}, {2, 5}, {1, 6}}})},
        {"touching itself in a corner", polygon({{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}})},
        {"touching itself along an edge", polygon({{{0, 0},
                                                    {6, 0},
                                                    {6, 4},
                                                    {3, 4},
                                                    {3, 2},
                                                    {4, 2},
                                                    {4, 1},
                                                    {2, 1},
                                                    {2, 2},
                                                    {3, 2},
                                                    {3, 4},
                                                    {0, 4}}})},
        {"a hole that touches the border in a corner",
         polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 0}, {2, 1}, {1, 2}}})},
        {"a hole that touches an edge",
         polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{2, 0}, {3, 2}, {1, 2}}})},
        {"a hole along an edge", polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 0}, {3, 0}, {2, 2}}})},
        {"a hole as large as the polygon",
         polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 0}, {4, 0}, {4, 4}, {0, 4}}})},
        {"two holes that touch in a point",
         polygon({{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{1, 1}, {3, 3}, {1, 3}}, {{3, 3}, {5, 5}, {3, 5}}})},
        {"holes that close a ring", polygon({{{0, 0}, {9, 0}, {9, 9}, {0, 9}},
                                             {{2, 2}, {5, 2}, {2, 5}},
                                             {{5, 2}, {7, 7}, {6, 5}},
                                             {{7, 7}, {2, 5}, {4, 6}}})},
        {"a hole that leaves the polygon",
         polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{2, 2}, {6, 2}, {2, 3}}})},
        {"an island in a hole",
         polygon(
             {{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{1, 1}, {8, 1}, {8, 8}, {1, 8}}, {{3, 3}, {5, 3}, {4, 6}}})},
        {"an island in a hole in an island", polygon({{{0, 0}, {20, 0}, {20, 20}, {0, 20}},
                                                      {{1, 1}, {1, 19}, {19, 19}, {19, 1}},
                                                      {{2, 2}, {18, 2}, {18, 18}, {2, 18}},
                                                      {{5, 5}, {5, 6}, {6, 5}},
                                                      {{8, 5}, {9, 6}, {9, 5}}})},
        {"a pentagram", polygon({{{0, 10}, {6, -8}, {-9.5, 3}, {9.5, 3}, {-6, -8}}})},
        {"run around twice", polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}})},
        {"nearly collinear", polygon({{{0, 0}, {0.5, 1e-17}, {1, 0}, {1, 1}}})},
        {"needles", polygon({{{0, 0}, {1, 1e-15}, {2, 0}, {1, 1e-300}, {3, 1}}})},
        {"huge and tiny", polygon({{{0, 0}, {1e300, 0}, {1e300, 1e300}, {1e-300, 1e-300}, {0, 1e300}}})},
        {"far from the origin", polygon({{{6378137.0, 1e7},
                                          {6378137.1, 1e7},
                                          {6378137.1, 1e7 + 0.1},
                                          {6378137.05, 1e7 + 0.01},
                                          {6378137.0, 1e7 + 0.1}}})},
        {"crossings a grid apart", polygon({{{0, 0}, {1, 1}, {1, 1 - 1e-15}, {0, 1e-15}, {1, 0}, {0, 1}}})},
    };
    for (const auto& [name, made] : nasty)
        EXPECT_EQ(cut(made).defect, "") << name;
}

TEST(Tessellation, OfTenThousandPolygonsWithHolesFillsThemWithoutOverlap)
{
    Random random(1);
    std::size_t holes = 0, triangles = 0;
    for (int i = 0; i < 10000; ++i)
    {
        const Polygon made = testsupport::starWithHoles(random);
        const Cut result = cut(made);
        ASSERT_EQ(result.defect, "") << i << "\n" << text(made);
        // Euler: a polygon of n corners with h holes has n + 2h - 2 triangles.
        const std::size_t h = made.contourSizes.size() - 1;
        ASSERT_EQ(result.triangles.size(), made.corners.size() + 2 * h - 2) << i << "\n" << text(made);
        holes += h;
        triangles += result.triangles.size();
    }
    EXPECT_GT(holes, 20000u);
    EXPECT_GT(triangles, 300000u);
}

/// A comb with diagonal teeth: its ears are long and thin, and their boxes contain other teeth.
Polygon slantedComb(Random& random, std::uint32_t teeth)
{
    std::vector<glm::dvec2> contour = {{1.0, 0.0}, {0.0, 0.0}};
    for (std::uint32_t i = 0; i < teeth; ++i)
        for (const double reach : {0.0, 0.5 + 0.5 * random.unit()})
            contour.push_back({(i + (reach > 0.0 ? 0.5 : 0.0)) / teeth + reach, 0.1 + reach});
    contour.push_back({1.0, 0.1});
    std::reverse(contour.begin(), contour.end());
    Polygon comb;
    comb.add(contour);
    return comb;
}

TEST(Tessellation, OfPolygonsWithManyCornersFillsThemWithoutOverlap)
{
    Random random(7);
    Polygon star;
    star.add(testsupport::star(random, {0, 0}, 0.5, 600));
    for (const Polygon& made : {star, slantedComb(random, 300)})
    {
        const Cut result = cut(made);
        EXPECT_EQ(result.defect, "");
        EXPECT_EQ(result.triangles.size(), made.corners.size() - 2);
    }
}

TEST(Tessellation, OfTenThousandTanglesIsTheirInside)
{
    Random random(2);
    std::size_t crossings = 0, merged = 0;
    for (int i = 0; i < 10000; ++i)
    {
        const Polygon made = testsupport::tangle(random);
        const Cut odd = cut(made);
        ASSERT_EQ(odd.defect, "") << i << "\n" << text(made);
        const Cut nonZero = cut(made, InsideRule::nonZero);
        ASSERT_EQ(nonZero.defect, "") << i << "\n" << text(made);
        crossings += odd.outline.crossings;
        merged += odd.outline.unusedCorners;
    }
    EXPECT_GT(crossings, 10000u);
    EXPECT_GT(merged, 10000u);
}

TEST(Tessellation, CheckFindsEveryKindOfDefect)
{
    Random random(4);
    const Polygon made = testsupport::starWithHoles(random);
    const Cut sound = cut(made);
    ASSERT_EQ(sound.defect, "");
    const double area = testsupport::oddArea(inPlaneOf(sound.outline, made));
    const auto defect = [&](const std::vector<Triangle>& triangles)
    { return testsupport::defectOf(sound.outline.points, triangles, area); };
    auto mutated = sound.triangles;
    mutated.pop_back();
    EXPECT_THAT(defect(mutated), testing::HasSubstr("area"));
    mutated.push_back(mutated.front());
    EXPECT_THAT(defect(mutated), testing::HasSubstr("same side"));
    mutated = sound.triangles;
    std::swap(mutated[0][0], mutated[0][1]);
    EXPECT_THAT(defect(mutated), testing::HasSubstr("turned over"));
    const std::vector<glm::dvec2> two = {{0, 0}, {1, 0}, {0, 1}, {0.9, 0.1}, {1.9, 0.1}, {0.9, 1.1}};
    EXPECT_EQ(testsupport::defectOf(two, {{0, 1, 2}}, 0.5), "");
    EXPECT_EQ(testsupport::defectOf(two, {{0, 1, 2}, {3, 4, 5}}, 1.0), "");
    EXPECT_EQ(testsupport::defectOf({two[0], two[1], two[2], {0.8, 0.1}, two[4], two[5]},
                                    {{0, 1, 2}, {3, 4, 5}}, 1.05),
              "two triangles overlap");
    // A corner on the edge of another triangle.
    EXPECT_TRUE(testsupport::hasTJunction({{0, 0}, {2, 0}, {0, 2}, {1, 0}, {1, -1}}, {{0, 1, 2}, {0, 4, 3}}));
}

TEST(Tessellation, RefusesWhatIsNoPolygon)
{
    const std::uint32_t size = 4;
    std::vector<glm::dvec3> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    EXPECT_FALSE(tessellate(corners, std::span(&size, 1)));
    corners.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
    const auto refused = tessellate(corners, std::span(&size, 1));
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message(), testing::HasSubstr("corner 3"));
}

} // namespace
