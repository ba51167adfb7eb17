// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgRoads/core/geometry/PlanElement.h>

namespace
{

using namespace osgRoads::core;

/// The end of a clothoid by Simpson's rule in so many steps.
glm::dvec2 clothoidBySimpson(double k0, double k1, double length, int steps)
{
    const auto direction = [&](double s)
    {
        const double heading = s * (k0 + 0.5 * (k1 - k0) / length * s);
        return glm::dvec2(std::cos(heading), std::sin(heading));
    };
    const double h = length / steps;
    glm::dvec2 sum = direction(0.0) + direction(length);
    for (int i = 1; i < steps; ++i)
        sum += direction(i * h) * (i % 2 ? 4.0 : 2.0);
    return sum * (h / 3.0);
}

double distance(glm::dvec2 a, glm::dvec2 b)
{
    return glm::length(a - b);
}

TEST(Clothoid, IsWithinAMicrometreOfFineQuadrature)
{
    const double cases[][3] = {{0.0, 0.01, 100.0},  {0.02, -0.02, 300.0}, {-0.1, 0.3, 40.0},
                               {1e-9, 2e-9, 500.0}, {0.0, 2.0, 30.0},     {0.005, 0.005, 1000.0}};
    for (const auto& [k0, k1, length] : cases)
    {
        const Clothoid spiral(k0, k1, length);
        for (const double share : {0.1, 0.5, 0.777, 1.0})
        {
            const double s = share * length;
            const double k = k0 + (k1 - k0) * share;
            EXPECT_LT(distance(spiral.at(s).position, clothoidBySimpson(k0, k, s, 20000)), 1e-7)
                << k0 << " " << k1 << " " << s;
            EXPECT_NEAR(spiral.at(s).curvature, k, 1e-12);
        }
    }
}

TEST(Clothoid, ADifferentCurvatureIsNoticed)
{
    EXPECT_GT(
        distance(Clothoid(0.0, 0.01, 100.0).at(100.0).position, clothoidBySimpson(0.0, 0.01001, 100.0, 2000)),
        1e-6);
}

TEST(PlanElement, AnArcIsACircle)
{
    const PlanElement left(0.0, 20.0, {5.0, 7.0}, 0.0, ArcShape{0.1});
    const PlanPoint quarter = left.at(10.0 * std::numbers::pi / 2.0);
    EXPECT_NEAR(quarter.position.x, 15.0, 1e-12);
    EXPECT_NEAR(quarter.position.y, 17.0, 1e-12);
    EXPECT_NEAR(quarter.headingRad, std::numbers::pi / 2.0, 1e-12);
    const PlanElement right(0.0, 20.0, {0.0, 0.0}, std::numbers::pi / 2.0, ArcShape{-0.1});
    const PlanPoint end = right.at(10.0 * std::numbers::pi / 2.0);
    EXPECT_NEAR(end.position.x, 10.0, 1e-12);
    EXPECT_NEAR(end.position.y, 10.0, 1e-12);
}

/// A quarter turn of radius 10 as a Bézier curve is a paramPoly3 that is known to be 0.03 % off the circle.
TEST(ParametricCubic, NormalizedGoesByArcLength)
{
    const double k = 4.0 / 3.0 * (std::sqrt(2.0) - 1.0), r = 10.0;
    // Control points (0,0), (kr,0), (r,r-kr), (r,r).
    const CurveCoefficients u{0.0, 3.0 * k * r, 3.0 * (r - 2.0 * k * r), r + 3.0 * k * r - 3.0 * r};
    const CurveCoefficients v{0.0, 0.0, 3.0 * (r - k * r), r - 3.0 * (r - k * r)};
    const double length = r * std::numbers::pi / 2.0;
    const ParametricCubic curve = ParametricCubic::normalized(u, v, length);
    EXPECT_NEAR(curve.lengthRatio(), 1.0, 3e-4);
    for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0})
    {
        const double angle = share * std::numbers::pi / 2.0;
        const PlanPoint point = curve.at(share * length);
        EXPECT_NEAR(point.position.x, r * std::sin(angle), 0.005);
        EXPECT_NEAR(point.position.y, r - r * std::cos(angle), 0.005);
        EXPECT_NEAR(point.headingRad, angle, 0.01);
    }
    // Equal steps of s are equal steps on the curve.
    double least = 1e9, most = 0.0;
    for (int i = 0; i < 100; ++i)
    {
        const double step =
            distance(curve.at(length * i / 100.0).position, curve.at(length * (i + 1) / 100.0).position);
        least = std::min(least, step);
        most = std::max(most, step);
    }
    EXPECT_LT(most / least, 1.0001);
}

TEST(ParametricCubic, ByArcLengthTakesTheParameterAsItIs)
{
    const ParametricCubic curve =
        ParametricCubic::byArcLength({0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 0.01, 0.0}, 10.0);
    EXPECT_DOUBLE_EQ(curve.at(4.0).position.x, 4.0);
    EXPECT_DOUBLE_EQ(curve.at(4.0).position.y, 0.16);
    EXPECT_NEAR(curve.at(4.0).headingRad, std::atan(0.08), 1e-15);
}

/// y = x²/2 from 0 to 1 is (√2 + asinh 1)/2 long.
TEST(ParametricCubic, Poly3EndsWhereItIsAsLongAsItSays)
{
    const double length = 0.5 * (std::sqrt(2.0) + std::asinh(1.0));
    const ParametricCubic curve = ParametricCubic::function({0.0, 0.0, 0.5, 0.0}, length);
    EXPECT_NEAR(curve.at(length).position.x, 1.0, 1e-9);
    EXPECT_NEAR(curve.at(length).position.y, 0.5, 1e-9);
    EXPECT_NEAR(curve.lengthRatio(), 1.0, 1e-11);
    EXPECT_NEAR(curve.at(0.0).curvature, 1.0, 1e-12);
}

TEST(PlanElement, NearestToInvertsAt)
{
    const PlanElement::Shape shapes[] = {
        LineShape{},
        ArcShape{0.02},
        ArcShape{-0.05},
        Clothoid(-0.01, 0.05, 50.0),
        ParametricCubic::normalized({0.0, 50.0, 0.0, 0.0}, {0.0, 0.0, 20.0, -14.0}, 50.5),
        ParametricCubic::function({0.0, 0.0, 0.004, -0.00003}, 50.0)};
    for (const PlanElement::Shape& shape : shapes)
        for (const double away : {0.0, 1e7})
        {
            const PlanElement element(0.0, 50.0, {away, -away}, 0.7, shape);
            for (double s = 1.0; s < 50.0; s += 3.7)
                for (const double t : {-7.0, 0.0, 5.0})
                {
                    const PlanPoint point = element.at(s);
                    const glm::dvec2 normal(-point.tangent().y, point.tangent().x);
                    EXPECT_NEAR(element.footOf(point.position + t * normal, s + 4.0, 0.0, 50.0).ds, s, 2e-8)
                        << element.word() << " " << away << " t " << t;
                }
        }
}

TEST(PlanElement, TheSagittaHoldsTheCurve)
{
    const PlanElement::Shape shapes[] = {
        ArcShape{0.05}, Clothoid(-0.05, 0.05, 40.0),
        ParametricCubic::normalized({0.0, 40.0, 0.0, 0.0}, {0.0, 0.0, 60.0, -50.0}, 46.0)};
    for (const PlanElement::Shape& shape : shapes)
    {
        const PlanElement element(0.0, 40.0, {3.0, 4.0}, 0.3, shape);
        const glm::dvec2 start = element.at(5.0).position, chord = element.at(15.0).position - start;
        const glm::dvec2 direction = chord / glm::length(chord);
        double farthest = 0.0;
        for (double s = 5.0; s <= 15.0; s += 0.1)
        {
            const glm::dvec2 away = element.at(s).position - start;
            farthest = std::max(farthest, std::fabs(away.y * direction.x - away.x * direction.y));
        }
        EXPECT_GE(element.sagitta(5.0, 15.0), farthest);
        EXPECT_LE(element.sagitta(5.0, 15.0), 4.0 * farthest + 0.5);
    }
}

} // namespace
