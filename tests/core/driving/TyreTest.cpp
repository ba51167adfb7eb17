// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/Tyre.h"

#include <cmath>
#include <vector>

#include "RoadSupport.h"
#include "simulation/vehicle/road/Roughness.h"
#include "simulation/vehicle/road/WheelGround.h"

namespace
{

using namespace simulation;

/// The force after rolling long enough to settle.
TyreForce settled(const RoadTyreData& tyre, double loadN, double grip, const TyreMotion& motion)
{
    glm::dvec2 bend(0.0);
    TyreForce force;
    for (int i = 0; i < 4000; ++i)
        force = tyreForce(tyre, loadN, grip, motion, 1e-3, bend);
    return force;
}

const RoadTyreData& tyre()
{
    static const auto vehicle = testsupport::roadVehicle();
    return vehicle->axles[0].tyre;
}

// At 0.1 % of slip and 0.1° the force is stiffness times slip, against the sliding.
TEST(TyreTest, SmallSlipMeetsItsStiffness)
{
    const double load = tyre().referenceLoadN, speed = 20.0;
    const glm::dvec2 stiffness = tyreStiffness(tyre(), load);
    EXPECT_NEAR(settled(tyre(), load, 1.0, {speed, -0.001 * speed, 0.0}).forceN.x, 0.001 * stiffness.x,
                0.02 * stiffness.x * 0.001);
    EXPECT_NEAR(settled(tyre(), load, 1.0, {speed, 0.0, 0.002 * speed}).forceN.y, -0.002 * stiffness.y,
                0.02 * stiffness.y * 0.002);
}

TEST(TyreTest, BothDirectionsShareOneFriction)
{
    const double load = 5000.0;
    const glm::dvec2 friction = load * tyreFriction(tyre(), load, 1.0);
    double most = 0.0;
    for (double along = -2.0; along <= 2.0; along += 0.2)
        for (double across = -2.0; across <= 2.0; across += 0.2)
            most = std::max(most,
                            glm::length(settled(tyre(), load, 1.0, {20.0, along, across}).forceN / friction));
    EXPECT_LE(most, 1.0 + 1e-9);
    EXPECT_GT(most, 0.99);
}

TEST(TyreTest, SlidingFrictionOpposesTheSliding)
{
    const glm::dvec2 sliding(12.0, 5.0);
    const double load = 4000.0;
    const TyreForce force = settled(tyre(), load, 0.5, {12.0, sliding.x, sliding.y});
    const glm::dvec2 friction = load * tyreFriction(tyre(), load, 0.5);
    EXPECT_NEAR(glm::length(force.forceN / friction), tyre().slidingShare, 1e-6);
    EXPECT_LT(force.forceN.x, 0.0);
    EXPECT_LT(force.forceN.y, 0.0);
}

TEST(TyreTest, AStandingTyreHoldsAsASpringAndGivesWayAtItsFriction)
{
    glm::dvec2 bend(0.0);
    glm::dvec2 held(0.0);
    for (int i = 0; i < 1000; ++i)
        held = tyreForce(tyre(), 4000.0, 1.0, {0.0, i < 500 ? 0.002 : 0.0, 0.0}, 1e-3, bend).forceN;
    EXPECT_NEAR(bend.x, -0.001, 1e-12);
    EXPECT_NEAR(held.x, -tyreStiffness(tyre(), 4000.0).x / tyre().relaxationAlongM * 0.001,
                0.05 * std::abs(held.x));
    for (int i = 0; i < 5000; ++i)
        held = tyreForce(tyre(), 4000.0, 1.0, {0.0, 0.5, 0.0}, 1e-3, bend).forceN;
    EXPECT_NEAR(-held.x, 4000.0 * tyreFriction(tyre(), 4000.0, 1.0).x * tyre().slidingShare, 1.0);
}

TEST(TyreTest, WithoutLoadThereIsNoForce)
{
    glm::dvec2 bend(0.1, 0.1);
    EXPECT_EQ(tyreForce(tyre(), 0.0, 1.0, {10.0, 3.0, 2.0}, 1e-3, bend).forceN, glm::dvec2(0.0));
    EXPECT_EQ(bend, glm::dvec2(0.0));
}

/// Takes ground of a height over x below a wheel that rolls east.
WheelContact touch(double (*height)(double), double hubX, double hubZ, double radius)
{
    WheelGround ground;
    const auto points = ground.pointsFor({hubX, 0.0, hubZ}, {1.0, 0.0, 0.0}, radius, 0.2, 0.0);
    std::vector<GroundPoint> answers;
    for (const glm::dvec3& point : points)
        answers.push_back({height(point.x), {0.0, 0.0, 1.0}, GroundKind::water, true}); // water is smooth
    ground.take(answers);
    return ground.contactOf({hubX, 0.0, hubZ}, radius);
}

TEST(WheelGroundTest, APlaneIsMetAtItsDistance)
{
    const WheelContact level = touch([](double) { return 1.0; }, 0.0, 1.28, 0.3);
    EXPECT_NEAR(level.depthM, 0.02, 1e-12);
    const WheelContact slope = touch([](double x) { return 0.1 * x; }, 0.0, 0.3, 0.3);
    EXPECT_NEAR(slope.depthM, 0.3 - 0.3 / std::sqrt(1.01), 1e-9);
    EXPECT_NEAR(slope.normal.x, -0.1 / std::sqrt(1.01), 1e-9);
}

TEST(WheelGroundTest, AKerbAheadPushesBack)
{
    const WheelContact kerb = touch([](double x) { return x < 0.15 ? 0.0 : 0.12; }, 0.0, 0.3, 0.3);
    EXPECT_GT(kerb.depthM, 0.02);
    EXPECT_LT(kerb.normal.x, -0.2);
}

TEST(WheelGroundTest, AHubBelowTheGroundIsDeepInIt)
{
    EXPECT_NEAR(touch([](double) { return 0.0; }, 0.0, -0.1, 0.3).depthM, 0.4, 1e-12);
}

TEST(RoughnessTest, StaysWithinItsAmplitudeAndIsAlwaysTheSame)
{
    double most = 0.0;
    for (int i = 0; i < 20000; ++i)
    {
        const glm::dvec3 place(0.13 * i, -0.29 * i, 0.0);
        const double height = roughnessM(GroundKind::gravel, place);
        EXPECT_EQ(height, roughnessM(GroundKind::gravel, place));
        most = std::max(most, std::abs(height));
    }
    EXPECT_LE(most, roughnessAmplitudeM(GroundKind::gravel));
    EXPECT_GT(most, 0.5 * roughnessAmplitudeM(GroundKind::gravel));
    EXPECT_EQ(roughnessM(GroundKind::gravel, {1e300, 0.0, 0.0}), 0.0);
}

} // namespace
