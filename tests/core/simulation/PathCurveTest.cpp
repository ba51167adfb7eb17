// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/PathCurve.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace simulation
{
namespace
{

/// from, from + step, … up to `to`.
std::vector<double> places(double from, double to, double step)
{
    std::vector<double> all;
    const auto last = static_cast<int>(std::floor((to - from) / step + 1e-9));
    for (int i = 0; i <= last; ++i)
        all.push_back(std::min(from + i * step, to));
    return all;
}

std::vector<PathVertex> bend()
{
    return {{0.0, {0, 0, 0}, {}},  {1.0, {10, 0, 1}, {}},  {2.5, {20, 5, 3}, {}},
            {3.0, {25, 9, 2}, {}}, {5.0, {30, 30, 0}, {}}, {6.0, {28, 40, 1}, {}}};
}

TEST(CubicSpline, ReproducesAStraightLineAndItsSlope)
{
    const CubicSpline spline({0.0, 1.0, 4.0, 5.0}, {1.0, 3.0, 9.0, 11.0}, CubicSpline::Kind::natural);
    for (const double u : places(0.0, 5.0, 0.125))
    {
        EXPECT_NEAR(spline.at(u).value, 1.0 + 2.0 * u, 1e-12);
        EXPECT_NEAR(spline.at(u).first, 2.0, 1e-12);
        EXPECT_NEAR(spline.at(u).second, 0.0, 1e-12);
    }
}

TEST(CubicSpline, IsTwiceContinuousAndFreeOfCurvatureAtItsEnds)
{
    const CubicSpline spline({0.0, 1.0, 2.5, 3.0, 5.0}, {0.0, 2.0, -1.0, 4.0, 4.0},
                             CubicSpline::Kind::natural);
    EXPECT_NEAR(spline.at(0.0).second, 0.0, 1e-12);
    EXPECT_NEAR(spline.at(5.0).second, 0.0, 1e-12);
    for (const double knot : {1.0, 2.5, 3.0})
    {
        const CubicSpline::Sample before = spline.at(knot - 1e-9);
        const CubicSpline::Sample after = spline.at(knot + 1e-9);
        EXPECT_NEAR(before.first, after.first, 1e-6);
        EXPECT_NEAR(before.second, after.second, 1e-6);
    }
}

TEST(PathCurve, MeetsEveryVertexExactlyInBothModes)
{
    for (const FollowingMode mode : {FollowingMode::position, FollowingMode::follow})
        for (const bool closed : {false, true})
        {
            const PathCurve curve(bend(), mode, closed ? std::optional(1.5) : std::nullopt);
            for (const PathVertex& vertex : bend())
                EXPECT_EQ(curve.at(vertex.parameter).position, vertex.position);
            EXPECT_EQ(curve.isClosed(), closed);
        }
}

TEST(PathCurve, AClosedCurveComesRoundSmoothly)
{
    const PathCurve curve(bend(), FollowingMode::follow, 1.5);
    const PathPoint end = curve.at(7.5 - 1e-7);
    const PathPoint begin = curve.at(7.5 + 1e-7);
    EXPECT_NEAR(glm::length(end.position - begin.position), 0.0, 1e-4);
    EXPECT_NEAR(glm::length(end.tangent - begin.tangent), 0.0, 1e-3);
    EXPECT_EQ(curve.at(7.5 + 2.5).position, curve.at(2.5).position);
}

TEST(PathCurve, TangentIsTheDerivativeOfThePosition)
{
    const PathCurve curve(bend(), FollowingMode::follow, std::nullopt);
    for (const double u : places(0.1, 5.8, 0.1))
    {
        const glm::dvec3 slope = (curve.at(u + 1e-6).position - curve.at(u - 1e-6).position) / 2e-6;
        EXPECT_NEAR(glm::length(slope - curve.at(u).tangent), 0.0, 1e-5);
    }
}

TEST(PathCurve, DistanceAndParameterAreInverse)
{
    for (const FollowingMode mode : {FollowingMode::position, FollowingMode::follow})
    {
        const PathCurve curve(bend(), mode, std::nullopt);
        for (const double s : places(0.0, curve.lengthM(), 0.37))
            EXPECT_NEAR(curve.distanceAt(curve.parameterAt(s)), s, 1e-9);
        double length = 0.0;
        for (int i = 0; i < 60'000; ++i)
            length += glm::length(curve.at((i + 1) * 1e-4).position - curve.at(i * 1e-4).position);
        EXPECT_NEAR(length, curve.lengthM(), 1e-3);
    }
}

TEST(PathCurve, CurvatureOfACircleIsItsInverseRadius)
{
    std::vector<PathVertex> circle;
    for (int i = 0; i < 36; ++i)
    {
        const double angle = i * std::numbers::pi / 18.0;
        circle.push_back({i * 1.0, {50.0 * std::cos(angle), 50.0 * std::sin(angle), 0.0}, {}});
    }
    const PathCurve curve(circle, FollowingMode::follow, 1.0);
    for (const double u : places(0.0, 35.7, 0.7))
        EXPECT_NEAR(curve.at(u).planCurvature(), 1.0 / 50.0, 1e-4);
}

TEST(PathCurve, GivenHeadingsCrossTheFullTurnTheShortWay)
{
    std::vector<PathVertex> vertices = bend();
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i].orientation.headingRad = i % 2 == 0 ? 3.1 : -3.1;
    const PathCurve curve(vertices, FollowingMode::follow, std::nullopt);
    for (const double u : places(0.0, 6.0, 0.05))
        EXPECT_GT(std::fabs(std::remainder(*curve.at(u).headingRad, 2.0 * std::numbers::pi)), 3.0);
}

} // namespace
} // namespace simulation
