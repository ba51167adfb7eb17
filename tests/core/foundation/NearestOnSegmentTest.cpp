// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <foundation/NearestOnSegment.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

using foundation::distanceToLine;
using foundation::nearestOnSegment;
using foundation::nearestShare;

TEST(NearestOnSegment, IsTheFootOfThePerpendicular)
{
    EXPECT_DOUBLE_EQ(nearestShare(glm::dvec2(3.0, 7.0), glm::dvec2(1.0, 2.0), glm::dvec2(9.0, 2.0)), 0.25);
    EXPECT_EQ(nearestOnSegment(glm::dvec3(1.0, 1.0, 5.0), glm::dvec3(0.0), glm::dvec3(2.0, 2.0, 0.0)),
              glm::dvec3(1.0, 1.0, 0.0));
    EXPECT_FLOAT_EQ(nearestShare(glm::vec2(0.5f, -1.0f), glm::vec2(0.0f), glm::vec2(1.0f, 0.0f)), 0.5f);
}

TEST(NearestOnSegment, IsAnEndBeyondTheSegment)
{
    const glm::dvec2 a(0.0, 0.0), b(1.0, 0.0);
    EXPECT_EQ(nearestShare(glm::dvec2(-2.0, 1.0), a, b), 0.0);
    EXPECT_EQ(nearestShare(glm::dvec2(4.0, 1.0), a, b), 1.0);
}

TEST(NearestOnSegment, IsThePlaceOfASegmentWithoutLength)
{
    EXPECT_EQ(nearestShare(glm::dvec2(3.0, 4.0), glm::dvec2(1.0), glm::dvec2(1.0)), 0.0);
    EXPECT_EQ(nearestOnSegment(glm::dvec2(3.0, 4.0), glm::dvec2(1.0), glm::dvec2(1.0)), glm::dvec2(1.0));
}

TEST(NearestOnSegment, TellsHowFarALineIs)
{
    const std::vector<glm::dvec2> line{{0.0, 0.0}, {10.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}};
    EXPECT_DOUBLE_EQ(distanceToLine(glm::dvec2(4.0, 3.0), line), 3.0);
    EXPECT_DOUBLE_EQ(distanceToLine(glm::dvec2(12.0, 5.0), line), 2.0);
    EXPECT_DOUBLE_EQ(distanceToLine(glm::dvec2(-3.0, -4.0), line), 5.0);
    EXPECT_TRUE(std::isinf(distanceToLine(glm::dvec2(1.0), std::vector<glm::dvec2>{{0.0, 0.0}})));
}
