// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <quadric/AccumulatedQuadric.h>

#include <osgPMObjects/core/simplify/Quadric.h>

namespace
{

using osgPMObjects::core::AccumulatedQuadric;
using osgPMObjects::core::Quadric;

// The cube of side 2 in Jin, *Polygon Techniques*: e is the middle of the edge between front and top; c is
// the end of that edge, at the right side.
TEST(Quadric, CostsNothingFromEToCAndOneFromCToEOnTheCubeOfThePaper)
{
    const glm::dvec3 front(0, -1, 0), top(0, 0, 1), right(1, 0, 0), e(0, -1, 1), c(1, -1, 1);
    Quadric atE, atC;
    for (const glm::dvec3& plane : {front, top})
        atE.addPlane(plane, 1.0);
    for (const glm::dvec3& plane : {front, top, right})
        atC.addPlane(plane, 1.0);
    EXPECT_EQ(atE.at(c - e), 0.0);
    EXPECT_EQ(atC.at(e - c), 1.0);
}

TEST(Quadric, IsTheWeightedSumOfSquaredDistances)
{
    const glm::dvec3 a = glm::dvec3(2, 3, 6) / 7.0, b = glm::dvec3(-4, 4, 7) / 9.0, p(0.3, -1.7, 2.9);
    Quadric quadric;
    quadric.addPlane(a, 2.0);
    quadric.addPlane(b, 0.5);
    const double da = glm::dot(a, p), db = glm::dot(b, p);
    EXPECT_NEAR(quadric.at(p), 2.0 * da * da + 0.5 * db * db, 1e-12);
    EXPECT_NEAR(glm::dot(p, quadric.matrix() * p), quadric.at(p), 1e-12);
    EXPECT_NEAR(quadric.trace(), 2.5, 1e-12);
}

/// Two positions of the cube become one at a third place: planes that do not pass through it are not
/// forgotten.
TEST(Quadric, AccumulatedIsTheSumOfSquaredDistancesFromThePlanesOfBothPositions)
{
    const glm::dvec3 front(0, -1, 0), top(0, 0, 1), right(1, 0, 0), e(0, -1, 1), c(1, -1, 1),
        place(0.4, -0.7, 0.9);
    AccumulatedQuadric atE, atC;
    for (const glm::dvec3& plane : {front, top})
        atE.planes.addPlane(plane, 1.0);
    for (const glm::dvec3& plane : {front, top, right})
        atC.planes.addPlane(plane, 2.0);
    const AccumulatedQuadric both = atE.about(place - e) + atC.about(place - c);
    // 0.3 from the front, 0.1 below the top, 0.6 from the right side
    EXPECT_NEAR(both.at({0, 0, 0}), 3.0 * (0.09 + 0.01) + 2.0 * 0.36, 1e-12);
    EXPECT_NEAR(both.constant, both.at({0, 0, 0}), 1e-12);
    EXPECT_NEAR(both.at(c - place), 0.0, 1e-12);
    EXPECT_NEAR(both.at(e - place), 2.0, 1e-12);
    EXPECT_NEAR(both.about(e - place).about(c - e).constant, 0.0, 1e-12);
}

} // namespace
