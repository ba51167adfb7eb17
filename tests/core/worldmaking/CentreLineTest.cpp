// SPDX-License-Identifier: Apache-2.0
// The rounded line of a street. Figures are worked by hand.
#include "worldmaking/streets/CentreLine.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace
{

using worldmaking::CentreLine;

TEST(CentreLine, ARightAngleLeavesItsPointByTheOffsetThatIsAllowed)
{
    // reach r = 2 m / tan(22.5°) = 4.828 m; radius the same; the arc is 7.585 m long, the two legs lose 4.828
    // m each.
    const CentreLine line({{0, 0}, {100, 0}, {100, 100}});
    const double reach = 2.0 / std::tan(std::numbers::pi / 8.0);
    EXPECT_NEAR(line.leastRadiusM(), reach, 1e-9);
    EXPECT_NEAR(line.lengthM(), 2.0 * (100.0 - reach) + 0.5 * std::numbers::pi * reach, 1e-9);
    const auto middle = line.at(line.pointsM()[1]).position;
    EXPECT_NEAR(glm::distance(middle, glm::dvec2(100, 0)), 2.0, 1e-9);
}

TEST(CentreLine, PlaceAndHeadingHaveNoStep)
{
    const CentreLine line({{0, 0}, {30, 5}, {35, 25}, {35.2, 25.3}, {10, 40}, {12, 90}, {60, 91}});
    for (double s = 0.01; s < line.lengthM(); s += 0.01)
    {
        const auto before = line.at(s - 0.01), after = line.at(s);
        EXPECT_NEAR(glm::distance(before.position, after.position), 0.01, 1e-4) << s;
        const double turn = std::remainder(after.headingRad - before.headingRad, 2.0 * std::numbers::pi);
        EXPECT_LT(std::fabs(turn), 0.01 / line.leastRadiusM() + 1e-6) << s;
    }
    EXPECT_NEAR(glm::distance(line.at(0.0).position, glm::dvec2(0, 0)), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(line.at(line.lengthM()).position, glm::dvec2(60, 91)), 0.0, 1e-6);
    EXPECT_EQ(line.pointsM().size(), 7u);
}

TEST(CentreLine, APartIsWhereTheWholeIs)
{
    const CentreLine line({{0, 0}, {50, 0}, {80, 40}, {120, 40}});
    const auto part = line.part(20.0, line.lengthM() - 15.0);
    double end = 0.0;
    for (const auto& element : part.elements())
    {
        EXPECT_NEAR(element.s, end, 1e-9);
        end = element.s + element.length;
    }
    EXPECT_NEAR(end, line.lengthM() - 35.0, 1e-9);
    for (double s = 0.0; s < end; s += 1.0)
        EXPECT_NEAR(glm::distance(part.at(s).position, line.at(s + 20.0).position), 0.0, 1e-6) << s;
}

} // namespace
