// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <viewlod/Frustum.h>

namespace
{

using viewlod::Frustum;

Frustum lookingNorth()
{
    const glm::dmat4 view = glm::lookAt(glm::dvec3(0.0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1));
    return Frustum(glm::perspective(glm::radians(60.0), 1.0, 1.0, 1000.0) * view);
}

TEST(Frustum, SphereAheadIsInsideAndCrossesNothing)
{
    const auto verdict = lookingNorth().classify({0, 100, 0}, 5.0);
    EXPECT_FALSE(verdict.outside);
    EXPECT_EQ(verdict.crossing, 0);
}

TEST(Frustum, SphereBehindAsideAndBeyondIsOutside)
{
    for (const glm::dvec3 centre :
         {glm::dvec3(0, -100, 0), {200, 100, 0}, {-200, 100, 0}, {0, 100, 200}, {0, 2000, 0}})
        EXPECT_TRUE(lookingNorth().classify(centre, 5.0).outside);
}

TEST(Frustum, SphereOnOnePlaneCrossesThatPlaneAlone)
{
    const double side = 100.0 * std::tan(glm::radians(30.0));
    const auto verdict = lookingNorth().classify({side, 100, 0}, 5.0);
    EXPECT_FALSE(verdict.outside);
    EXPECT_EQ(std::popcount(verdict.crossing), 1);
}

TEST(Frustum, PlanesOutsideTheMaskAreNotAskedAgain)
{
    // Outside the right plane, but the mask says that a parent was inside it.
    const auto all = lookingNorth().classify({200, 100, 0}, 5.0);
    ASSERT_TRUE(all.outside);
    EXPECT_FALSE(lookingNorth().classify({200, 100, 0}, 5.0, 0).outside);
}

TEST(Frustum, InheritedMasksAgreeWithFullTestsOnNestedSpheres)
{
    const Frustum frustum = lookingNorth();
    int asked = 0;
    for (int i = 0; i < 2000; ++i)
    {
        const glm::dvec3 parent(i % 37 * 10.0 - 180.0, i % 53 * 22.0 - 60.0, i % 29 * 12.0 - 170.0);
        const auto outer = frustum.classify(parent, 30.0);
        const glm::dvec3 child = parent + glm::dvec3(i % 7 - 3, i % 5 - 2, i % 3 - 1) * 4.0;
        const auto full = frustum.classify(child, 8.0);
        if (outer.outside)
        {
            EXPECT_TRUE(full.outside);
            continue;
        }
        ++asked;
        const auto inherited = frustum.classify(child, 8.0, outer.crossing);
        EXPECT_EQ(inherited.outside, full.outside);
        if (!full.outside)
        {
            EXPECT_EQ(inherited.crossing, full.crossing);
        }
    }
    EXPECT_GT(asked, 100);
}

} // namespace
