// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/EntityLook.h"

#include <gtest/gtest.h>

using scenery::entityLook;
using scenery::models::EntityKind;

namespace
{

simulation::ScenarioObject vehicle(const std::string& category, const std::string& name,
                                   const glm::dvec3& size)
{
    simulation::Vehicle made;
    made.name = name;
    made.category = category;
    made.box = {{1.3, 0.0, 0.5 * size.z}, size.x, size.y, size.z};
    made.frontAxle = simulation::Axle{0.5, 0.64, 1.5, 2.7, 0.32};
    made.rearAxle = {0.5, 0.64, 1.5, 0.0, 0.32};
    simulation::ScenarioObject object;
    object.name = "A";
    object.object = made;
    return object;
}

template<class Object>
EntityKind kindOf(const std::string& category, const std::string& name)
{
    Object made;
    made.name = name;
    made.category = category;
    simulation::ScenarioObject object;
    object.object = made;
    return entityLook(object)->shape.kind;
}

} // namespace

TEST(EntityLook, TakesSizeAxlesAndColourOfTheFile)
{
    const auto look = entityLook(vehicle("car", "car_blue", {4.5, 1.8, 1.5}));
    ASSERT_TRUE(look);
    EXPECT_EQ(look->shape.kind, EntityKind::car);
    EXPECT_EQ(look->note, "");
    EXPECT_DOUBLE_EQ(look->shape.lengthM, 4.5);
    ASSERT_EQ(look->shape.axles.size(), 2U);
    EXPECT_TRUE(look->shape.axles[0].steers);
    EXPECT_FALSE(look->shape.axles[1].steers);
    EXPECT_GT(look->shape.blue, 2.0F * look->shape.red);
    EXPECT_NE(entityLook(vehicle("car", "car_red", {4.5, 1.8, 1.5}))->shape, look->shape);
}

TEST(EntityLook, SaysWhenABoxCannotBeOfTheKind)
{
    const auto look = entityLook(vehicle("bus", "bus_blue", {4.5, 1.8, 1.5}));
    ASSERT_TRUE(look);
    EXPECT_EQ(look->shape.kind, EntityKind::bus);
    EXPECT_GT(look->shape.lengthM, 10.0);
    EXPECT_EQ(look->note, "A: a bounding box of 4.5 m by 1.8 m by 1.5 m cannot be that of its category; it "
                          "is drawn 11.9 m long");
}

TEST(EntityLook, KindFollowsCategoryAndNames)
{
    EXPECT_EQ(entityLook(vehicle("truck", "semi_tractor", {6.0, 2.5, 3.6}))->shape.kind, EntityKind::tractor);
    EXPECT_EQ(entityLook(vehicle("truck", "truck", {8.0, 2.5, 3.6}))->shape.kind, EntityKind::lorry);
    EXPECT_EQ(entityLook(vehicle("trailer", "semi_trailer", {12.0, 2.5, 3.6}))->shape.kind,
              EntityKind::semitrailer);
    EXPECT_EQ(kindOf<simulation::Pedestrian>("animal", "moose"), EntityKind::animal);
    EXPECT_EQ(kindOf<simulation::Pedestrian>("pedestrian", "adult"), EntityKind::pedestrian);
    EXPECT_EQ(kindOf<simulation::MiscObject>("obstacle", "cone-45"), EntityKind::cone);
    EXPECT_EQ(kindOf<simulation::MiscObject>("barrier", "x"), EntityKind::barrier);
    EXPECT_EQ(kindOf<simulation::MiscObject>("obstacle", "box"), EntityKind::box);
    EXPECT_FALSE(entityLook(vehicle("aircraft", "c172", {8.0, 11.0, 2.7})));
}
