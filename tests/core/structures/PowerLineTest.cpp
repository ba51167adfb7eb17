// SPDX-License-Identifier: Apache-2.0
#include "scenery/structures/PowerLine.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "scenery/structures/Catenary.h"

using scenery::catenary;
using scenery::Structure;
using scenery::StructureKind;

namespace
{

std::optional<double> flat(const glm::dvec2&)
{
    return 100.0;
}

/// A ridge of 17 m across the line.
std::optional<double> ridge(const glm::dvec2& plan)
{
    return 100.0 + 17.0 * std::exp(-std::pow((plan.x - 150.0) / 40.0, 2.0));
}

Structure line(StructureKind kind, std::vector<glm::dvec2> points)
{
    Structure made;
    made.kind = kind;
    made.line = std::move(points);
    made.heightM = kind == StructureKind::powerLine ? 28.0 : 9.5;
    return made;
}

/// The least height of all wires above the ground.
double leastClearanceM(const Structure& made, const std::vector<scenery::Support>& supports,
                       const foundation::HeightInPlan& ground)
{
    double least = 1e9;
    for (std::size_t i = 0; i + 1 < supports.size(); ++i)
        for (const auto& wire : scenery::wiresOf(made.kind))
            for (const glm::dvec3& point : catenary(wireAt(supports[i], wire), wireAt(supports[i + 1], wire),
                                                    scenery::kLineConstantM, 40))
                least = std::min(least, point.z - *ground(glm::dvec2(point)));
    return least;
}

} // namespace

TEST(Catenary, HasTheSagOfItsConstant)
{
    const auto sag = [](double lengthM) {
        return 30.0 - catenary({0, 0, 30}, {lengthM, 0, 30}, scenery::kLineConstantM, 2)[1].z;
    };
    EXPECT_NEAR(sag(300.0), 7.5, 0.05);
    EXPECT_NEAR(sag(400.0), 13.4, 0.1);
}

TEST(Catenary, EndsWhereItIsFastenedOnSlopesToo)
{
    const glm::dvec3 from(10, 20, 30), to(210, 120, 95);
    const auto points = catenary(from, to, 1500.0, 20);
    EXPECT_NEAR(glm::distance(points.front(), from), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(points.back(), to), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(points[19], to), glm::distance(from, to) / 20.0, 1.5) << "no jump at the end";
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        EXPECT_GT(points[i - 1].z - 2.0 * points[i].z + points[i + 1].z, 0.0) << "it hangs";
}

TEST(PowerLine, StandsAtTheMapsPointsAndBetweenThemWhereASpanIsTooLong)
{
    const auto two = supportsOf(line(StructureKind::powerLine, {{0, 0}, {500, 0}}), flat);
    ASSERT_EQ(two.size(), 2u);
    const auto more = supportsOf(line(StructureKind::powerLine, {{0, 0}, {1400, 0}}), flat);
    ASSERT_EQ(more.size(), 5u);
    EXPECT_NEAR(more[1].foot.x, 350.0, 1e-9);
    EXPECT_EQ(supportsOf(line(StructureKind::poleLine, {{0, 0}, {200, 0}}), flat).size(), 4u);
    const auto nowhere = [](const glm::dvec2&) { return std::optional<double>(); };
    EXPECT_TRUE(supportsOf(line(StructureKind::powerLine, {{0, 0}, {500, 0}}), nowhere).empty());
}

TEST(PowerLine, WiresKeepAwayFromTheGround)
{
    const Structure made = line(StructureKind::powerLine, {{0, 0}, {300, 0}});
    const auto supports = supportsOf(made, ridge);
    EXPECT_GT(leastClearanceM(made, supports, ridge), scenery::kClearanceM - 0.5);
    EXPECT_GT(supports[0].heightM, 28.0);
    auto asTheMapSays = supports;
    for (auto& support : asTheMapSays)
        support.heightM = 28.0;
    EXPECT_LT(leastClearanceM(made, asTheMapSays, ridge), 0.0) << "without the rule they run into the ridge";
}
