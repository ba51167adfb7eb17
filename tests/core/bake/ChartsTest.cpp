// SPDX-License-Identifier: Apache-2.0
#include <foundation/Angle.h>
#include <gtest/gtest.h>

#include <osgPMObjects/core/bake/Charts.h>

#include "MadeMeshes.h"
#include "Random.h"
#include "RoundMeshes.h"
#include "core/bake/FlatFaces.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::cube;
using testsupport::meshOf;

/// Returns the pairs of faces of one chart that overlap, found by testing all pairs.
std::size_t overlaps(const Mesh& mesh, const Charts& charts)
{
    std::size_t count = 0;
    for (const Chart& chart : charts.charts)
        for (std::size_t i = 0; i < chart.faces.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
            {
                const auto flat = [&](std::uint32_t f)
                {
                    const Face& face = mesh.faces[f];
                    return FlatTriangle{chart.flat(mesh.at(face, 0)), chart.flat(mesh.at(face, 1)),
                                        chart.flat(mesh.at(face, 2))};
                };
                if (overlap(flat(chart.faces[i]), flat(chart.faces[k]), 1e-9)) ++count;
            }
    return count;
}

/// A ramp with three turns around an axis: seen from above every turn hides the one below.
Mesh windingRamp()
{
    std::vector<glm::dvec3> positions;
    std::vector<std::array<std::uint32_t, 3>> faces;
    constexpr std::uint32_t kSteps = 48;
    for (std::uint32_t i = 0; i <= kSteps; ++i)
    {
        const double angle = 3.0 * 2.0 * std::numbers::pi * i / kSteps, height = 0.02 * i;
        positions.emplace_back(std::cos(angle), std::sin(angle), height);
        positions.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), height);
    }
    for (std::uint32_t i = 0; i < kSteps; ++i)
    {
        faces.push_back({2 * i, 2 * i + 1, 2 * i + 3});
        faces.push_back({2 * i, 2 * i + 3, 2 * i + 2});
    }
    return meshOf(std::move(positions), faces);
}

TEST(Charts, OfACubeAreItsSides)
{
    const Charts charts = makeCharts(cube());
    ASSERT_EQ(charts.charts.size(), 6u);
    for (const Chart& chart : charts.charts)
        EXPECT_EQ(chart.faces.size(), 2u);
    EXPECT_TRUE(coversFacesOnce(charts, 12));
}

TEST(Charts, CoverEveryFaceOnceAndDoNotOverlap)
{
    for (const Mesh& mesh : {testsupport::roundMesh(24, 12, testsupport::onSphere),
                             testsupport::roundMesh(48, 24, testsupport::onBumps), windingRamp()})
    {
        const Charts charts = makeCharts(mesh);
        EXPECT_TRUE(coversFacesOnce(charts, mesh.faces.size()));
        EXPECT_EQ(overlaps(mesh, charts), 0u);
        EXPECT_LT(charts.charts.size(), mesh.faces.size() / 8);
    }
}

TEST(Charts, CutASurfaceThatWindsOverItself)
{
    EXPECT_GE(makeCharts(windingRamp()).charts.size(), 3u);
}

TEST(Charts, FacesAreNoMoreAslantThanAllowed)
{
    const Mesh mesh = testsupport::roundMesh(48, 24, testsupport::onBumps);
    for (const double most : {30.0, 55.0, 75.0})
        for (const Chart& chart : makeCharts(mesh, {.mostSlantDeg = most}).charts)
            for (const std::uint32_t f : chart.faces)
            {
                const Face& face = mesh.faces[f];
                const glm::dvec3 area =
                    glm::cross(mesh.at(face, 1) - mesh.at(face, 0), mesh.at(face, 2) - mesh.at(face, 0));
                EXPECT_GE(glm::dot(glm::normalize(area), glm::cross(chart.right, chart.up)),
                          std::cos(foundation::radiansOf(most)) - 1e-12);
            }
}

TEST(Charts, AreMadeOfAnySoup)
{
    testsupport::Random random(3);
    const auto coordinate = [&] { return 2.0 * random.unit() - 1.0; };
    std::vector<glm::dvec3> positions;
    for (int i = 0; i < 40; ++i)
    {
        const double x = coordinate(), y = coordinate();
        positions.emplace_back(x, y, coordinate());
    }
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (int i = 0; i < 400; ++i) // some without area, many on one edge
    {
        const std::uint32_t a = random.below(40), b = random.below(40);
        faces.push_back({a, b, random.below(40)});
    }
    const Mesh mesh = meshOf(positions, faces);
    const Charts charts = makeCharts(mesh);
    EXPECT_TRUE(coversFacesOnce(charts, mesh.faces.size()));
    EXPECT_EQ(overlaps(mesh, charts), 0u);
    EXPECT_TRUE(makeCharts(Mesh()).charts.empty());
}

TEST(ChartsMutation, AFaceLessOrTwiceOrElsewhereIsSeen)
{
    const Charts charts = makeCharts(cube());
    Charts less = charts, twice = charts, elsewhere = charts;
    less.charts[2].faces.pop_back();
    twice.charts[2].faces.push_back(charts.charts[3].faces[0]);
    std::swap(elsewhere.chartOfFace[charts.charts[0].faces[0]],
              elsewhere.chartOfFace[charts.charts[1].faces[0]]);
    EXPECT_FALSE(coversFacesOnce(less, 12));
    EXPECT_FALSE(coversFacesOnce(twice, 12));
    EXPECT_FALSE(coversFacesOnce(elsewhere, 12));
}

TEST(ChartsMutation, OneChartForAllWouldOverlap)
{
    const Mesh mesh = windingRamp();
    Charts charts;
    charts.charts.resize(1);
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        charts.charts[0].faces.push_back(f);
    EXPECT_GT(overlaps(mesh, charts), 0u);
}

} // namespace
