// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/SunShadow.h"

#include <gtest/gtest.h>

#include <osg/ComputeBoundsVisitor>

#include "scenery/models/entities/DefaultSize.h"

namespace
{

namespace models = scenery::models;

models::EntityModel modelOf(models::EntityKind kind)
{
    models::EntityShape shape;
    shape.kind = kind;
    models::setDefaultSize(shape);
    return models::makeEntityModel(shape);
}

const glm::dvec3 kSun = glm::normalize(glm::dvec3(1.0, 0.0, 1.0)); // in the east, 45° high

simulation::GroundProvider slopeOf(double rise)
{
    return [rise](double x, double, double) -> std::optional<simulation::GroundSample>
    { return simulation::GroundSample{rise * x}; };
}

osg::BoundingBox boundsOfShadow(osg::Node* node)
{
    osg::ComputeBoundsVisitor visitor;
    node->accept(visitor);
    return visitor.getBoundingBox();
}

} // namespace

TEST(SunShadow, OfABoxIsAsWorkedByHand)
{
    // A crate of 1 m below a sun 45° high: its shadow reaches from its eastern side 2 m to the west.
    const models::EntityModel crate = modelOf(models::EntityKind::box);
    const models::ShadowMask mask = models::castShadow(crate, crate.pose({}), {glm::dmat3(1.0), kSun, 0.0});
    const double middle = crate.pose({})[0][3].x;
    for (const double x : {0.4, -0.4, -1.3})
        EXPECT_GT(mask.at({middle + x, 0.0}), 0.99) << x;
    for (const double x : {0.62, -1.62})
        EXPECT_LT(mask.at({middle + x, 0.0}), 0.01) << x;
    EXPECT_LT(mask.at({middle, 0.65}), 0.01);
    // The mutation: with the sun in the zenith nothing is dark to its west.
    EXPECT_LT(models::castShadow(crate, crate.pose({}), {}).at({middle - 1.3, 0.0}), 0.01);
}

TEST(SunShadow, GetsSofterWithHeight)
{
    const models::EntityModel glider = modelOf(models::EntityKind::glider);
    const auto darkest = [&](double heightM)
    {
        const auto mask = models::castShadow(glider, glider.pose({}), {glm::dmat3(1.0), kSun, heightM});
        return *std::max_element(mask.cover.begin(), mask.cover.end());
    };
    EXPECT_EQ(darkest(0.0), 255);
    EXPECT_LT(darkest(400.0), 200) << "the sun is wider than the wing there";
}

TEST(SunShadow, LiesOnTheGroundBelowWhatFlies)
{
    const models::EntityModel aircraft = modelOf(models::EntityKind::lightAircraft);
    simulation::EntityState state;
    state.position = {1000.0, 50.0, 200.0}; // the ground is at 100 m there
    scenery::SunShadow shadow;
    shadow.show(aircraft, aircraft.pose({}), state, kSun, slopeOf(0.1));
    ASSERT_NE(shadow.node()->getNodeMask(), 0U);
    const osg::BoundingBox box = boundsOfShadow(shadow.node());
    EXPECT_NEAR(box.center().x(), 900.0,
                4.0); // the height above the ground to the west, and the model's middle
    EXPECT_NEAR(box.zMax(), 0.1 * box.xMax(), 0.01) << "on the slope";
    EXPECT_NEAR(box.zMin(), 0.1 * box.xMin(), 0.01);
}

TEST(SunShadow, IsNotThereByNightNorVeryHighNorWithoutGround)
{
    const models::EntityModel aircraft = modelOf(models::EntityKind::lightAircraft);
    const auto isShown = [&](double heightM, const glm::dvec3& sun, const simulation::GroundProvider& ground)
    {
        simulation::EntityState state;
        state.position.z = heightM;
        scenery::SunShadow shadow;
        shadow.show(aircraft, aircraft.pose({}), state, sun, ground);
        return shadow.node()->getNodeMask() != 0U;
    };
    EXPECT_TRUE(isShown(100.0, kSun, slopeOf(0.0)));
    EXPECT_FALSE(isShown(100.0, glm::normalize(glm::dvec3(1.0, 0.0, 0.01)), slopeOf(0.0)));
    EXPECT_FALSE(isShown(100.0, {0.8, 0.0, -0.6}, slopeOf(0.0)));
    EXPECT_FALSE(isShown(5000.0, kSun, slopeOf(0.0)));
    EXPECT_FALSE(isShown(100.0, kSun, {}));
}

TEST(SunShadow, FollowsTheBodyOnASlope)
{
    // A car that stands on a slope casts its shadow onto the slope: the patch touches it everywhere.
    const models::EntityModel car = modelOf(models::EntityKind::car);
    simulation::EntityState state;
    state.position = {10.0, 0.0, 2.0};
    state.pitchDeg = -glm::degrees(std::atan(0.2));
    state.isOnGround = true;
    scenery::SunShadow shadow;
    shadow.show(car, car.pose({}), state, glm::normalize(glm::dvec3(0.3, 0.2, 1.0)), slopeOf(0.2));
    const osg::BoundingBox box = boundsOfShadow(shadow.node());
    EXPECT_NEAR(box.zMax(), 0.2 * box.xMax(), 0.01);
    EXPECT_LT(box.xMax() - box.xMin(), 7.0);
}
