// SPDX-License-Identifier: Apache-2.0
// Trajectories by curves: places and times worked by hand.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/NurbsCurve.h"
#include "simulation/player/ScenarioPlayer.h"

namespace simulation
{
namespace
{

constexpr double kQuarter = 0.5 * std::numbers::pi;

std::string followShape(const std::string& shape, const std::string& reference = "<None/>")
{
    return R"(<PrivateAction><RoutingAction><FollowTrajectoryAction><TrajectoryRef><Trajectory name="t" closed="false"><Shape>)" +
           shape + "</Shape></Trajectory></TrajectoryRef><TimeReference>" + reference +
           R"(</TimeReference><TrajectoryFollowingMode followingMode="position"/></FollowTrajectoryAction></RoutingAction></PrivateAction>)";
}

std::string place(const std::string& position)
{
    return "<Position>" + position + "</Position>";
}

/// Ego after a time, at 10 m/s where the trajectory has no times.
EntityState egoAfter(double timeS, const std::string& action)
{
    ScenarioText text;
    text.privates = teleport(R"(<WorldPosition x="0" y="0" h="0"/>)") + speedAction(10.0) + action;
    auto parsed = parseScenario(text.text(), "test.xosc");
    EXPECT_TRUE(parsed) << parsed.error().message();
    if (!parsed) return {};
    PlayerOptions options;
    options.clock = FixedClock::forStep(0.01);
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    if (!player) return {};
    while ((*player)->timeS() < timeS - 1e-9)
        (*player)->step();
    return (*player)->entities().front();
}

void expectAt(const EntityState& state, double x, double y, double headingRad, double within = 1e-3)
{
    EXPECT_NEAR(state.position.x, x, within);
    EXPECT_NEAR(state.position.y, y, within);
    EXPECT_NEAR(glm::radians(state.headingDeg), headingRad, within);
}

const std::string kLeftBend =
    R"(<Clothoid curvature="0.1" curvaturePrime="0" length="15.707963267948966" startTime="0" stopTime="2">)" +
    place(R"(<WorldPosition x="5" y="0" h="0"/>)") + "</Clothoid>";

TEST(Shape, AClothoidOfEvenCurvatureIsAnArc)
{
    // A quarter of a circle of 10 m around (5, 10); at 10 m/s half of it after 0.785 s.
    const EntityState half = egoAfter(0.78, followShape(kLeftBend));
    expectAt(half, 5.0 + 10.0 * std::sin(0.78), 10.0 - 10.0 * std::cos(0.78), 0.78);
    const EntityState after = egoAfter(2.0, followShape(kLeftBend));
    expectAt(after, 15.0, 10.0 + 20.0 - 10.0 * kQuarter, kQuarter);
}

TEST(Shape, AClothoidWithTimesTakesThem)
{
    // 15.7 m in 2 s.
    const EntityState state = egoAfter(1.0, followShape(kLeftBend, kTiming));
    expectAt(state, 5.0 + 10.0 * std::sin(0.5 * kQuarter), 10.0 - 10.0 * std::cos(0.5 * kQuarter),
             0.5 * kQuarter);
    EXPECT_NEAR(state.speedMps, 5.0 * kQuarter, 1e-3);
}

TEST(Shape, ACurvatureThatGrowsTurnsWithTheSquareOfTheWay)
{
    // Heading after 10 m: 0.5·0.02·10² = 1 rad; the integrals of Fresnel there: x 9.0452, y 3.1027.
    const std::string shape = R"(<Clothoid curvature="0" curvaturePrime="0.02" length="10">)" +
                              place(R"(<WorldPosition x="0" y="0" h="0"/>)") + "</Clothoid>";
    expectAt(egoAfter(1.0, followShape(shape)), 9.0452, 3.1027, 1.0);
}

TEST(Shape, ASplineGoesOnWhereASegmentEnds)
{
    const std::string shape =
        R"(<ClothoidSpline timeEnd="5"><ClothoidSplineSegment curvatureStart="0" curvatureEnd="0" length="10" timeStart="0"/>
<ClothoidSplineSegment curvatureStart="0.1" curvatureEnd="0.1" length="15.707963267948966" timeStart="1"/></ClothoidSpline>)";
    expectAt(egoAfter(1.0, followShape(shape)), 10.0, 0.0, 0.0);
    expectAt(egoAfter(2.0, followShape(shape)), 10.0 + 10.0 * std::sin(1.0), 10.0 - 10.0 * std::cos(1.0),
             1.0);
    // By its times the bend takes 4 s.
    expectAt(egoAfter(3.0, followShape(shape, kTiming)), 10.0 + 10.0 * std::sin(0.5 * kQuarter),
             10.0 - 10.0 * std::cos(0.5 * kQuarter), 0.5 * kQuarter);
}

TEST(Shape, ASegmentMayBeginElsewhereAndTurned)
{
    const std::string shape =
        R"(<ClothoidSpline><ClothoidSplineSegment curvatureStart="0" curvatureEnd="0" length="5" hOffset="1.5707963267948966"><PositionStart>
<WorldPosition x="3" y="2" h="0"/></PositionStart></ClothoidSplineSegment></ClothoidSpline>)";
    expectAt(egoAfter(0.2, followShape(shape)), 3.0, 4.0, kQuarter);
}

TEST(Shape, ANurbsOfOneArcIsThatArc)
{
    // The classic quarter of a circle: weights 1, 1/√2, 1.
    const double weight = 1.0 / std::numbers::sqrt2;
    const NurbsCurve arc({{10, 0, 0, 1}, glm::dvec4(10, 10, 0, 1) * weight, {0, 10, 0, 1}},
                         {0, 0, 0, 1, 1, 1}, 2);
    for (double u = 0.0; u <= 1.0; u += 0.125)
    {
        const glm::dvec3 point = arc.at(u);
        EXPECT_NEAR(glm::length(point), 10.0, 1e-12);
        const glm::dvec3 ahead = (arc.at(std::min(u + 1e-6, 1.0)) - arc.at(std::max(u - 1e-6, 0.0))) /
                                 (std::min(u + 1e-6, 1.0) - std::max(u - 1e-6, 0.0));
        EXPECT_NEAR(glm::length(arc.tangentAt(u) - ahead), 0.0, 1e-4);
        EXPECT_NEAR(arc.basis(0, u) + arc.basis(1, u) + arc.basis(2, u), 1.0, 1e-12);
    }
}

std::string straightNurbs(const std::string& middleTime)
{
    const auto point = [](const char* x, const std::string& time)
    {
        return "<ControlPoint time=\"" + time + "\">" +
               place(std::string("<WorldPosition x=\"") + x + R"(" y="0"/>)") + "</ControlPoint>";
    };
    return R"(<Nurbs order="3">)" + point("0", "0") + point("50", middleTime) + point("100", "4") +
           R"(<Knot value="0"/><Knot value="0"/><Knot value="0"/><Knot value="1"/><Knot value="1"/><Knot value="1"/></Nurbs>)";
}

TEST(Shape, ANurbsIsAtTheTimeOfAPointWhereThatPointPullsMost)
{
    // Evenly spaced points on a line: the place is 100 m times the parameter, and the middle point pulls most
    // at 0.5.
    expectAt(egoAfter(3.0, followShape(straightNurbs("3"), kTiming)), 50.0, 0.0, 0.0, 0.5);
    expectAt(egoAfter(1.0, followShape(straightNurbs("1"), kTiming)), 50.0, 0.0, 0.0, 0.5);
    expectAt(egoAfter(3.5, followShape(straightNurbs("3"), kTiming)), 75.0, 0.0, 0.0, 0.5);
}

TEST(Shape, APlaceOnATrajectoryIsSoFarAlongItAndBesideIt)
{
    const std::string trajectory =
        R"(<TrajectoryPosition s="15" t="2"><TrajectoryRef><Trajectory name="t" closed="false"><Shape><Polyline>)" +
        vertex(R"(<WorldPosition x="0" y="0"/>)") + vertex(R"(<WorldPosition x="10" y="0"/>)") +
        vertex(R"(<WorldPosition x="10" y="10"/>)") +
        "</Polyline></Shape></Trajectory></TrajectoryRef></TrajectoryPosition>";
    // 5 m up the second leg, 2 m to its left.
    expectAt(egoAfter(0.0, teleport(trajectory)), 8.0, 5.0, kQuarter, 1e-9);
}

struct ShapeMistake
{
    const char* name;
    const char* shape;
    const char* expected;
};

class ShapeMistakes : public testing::TestWithParam<ShapeMistake>
{
};

TEST_P(ShapeMistakes, AreToldInOneLine)
{
    ScenarioText text;
    text.privates = followShape(GetParam().shape, kTiming);
    const auto parsed = parseScenario(text.text(), "test.xosc");
    ASSERT_FALSE(parsed);
    EXPECT_NE(parsed.error().message().find(GetParam().expected), std::string::npos)
        << parsed.error().message();
}

INSTANTIATE_TEST_SUITE_P(
    Table, ShapeMistakes,
    testing::Values(
        ShapeMistake{
            "NoTime",
            R"(<Clothoid curvature="0" curvaturePrime="0" length="5" stopTime="2"><Position><WorldPosition x="0" y="0"/></Position></Clothoid>)",
            "startTime is missing, but the trajectory has a Timing"},
        ShapeMistake{
            "Backwards",
            R"(<Clothoid curvature="0" curvaturePrime="0" length="5" startTime="3" stopTime="2"><Position><WorldPosition x="0" y="0"/></Position></Clothoid>)",
            "stopTime is not later than the one before"},
        ShapeMistake{
            "Length",
            R"(<Clothoid curvature="0" curvaturePrime="0" length="0" startTime="0" stopTime="2"><Position><WorldPosition x="0" y="0"/></Position></Clothoid>)",
            "Clothoid/length is not above 0"},
        ShapeMistake{"NoSegment", R"(<ClothoidSpline timeEnd="3"/>)", "a ClothoidSpline has no segment"},
        ShapeMistake{
            "Knots",
            R"(<Nurbs order="2"><ControlPoint time="0"><Position><WorldPosition x="0" y="0"/></Position></ControlPoint><ControlPoint time="1"><Position><WorldPosition x="9" y="0"/></Position></ControlPoint><Knot value="0"/></Nurbs>)",
            "has 1 knots, not 4"}),
    [](const testing::TestParamInfo<ShapeMistake>& test) { return std::string(test.param.name); });

} // namespace
} // namespace simulation
