// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/EntityLook.h"

#include <set>
#include <tuple>

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
    return entityLook(object).shape.kind;
}

} // namespace

TEST(EntityLook, TakesSizeAxlesAndColourOfTheFile)
{
    const auto look = entityLook(vehicle("car", "car_blue", {4.5, 1.8, 1.5}));
    EXPECT_EQ(look.shape.kind, EntityKind::car);
    EXPECT_EQ(look.note, "");
    EXPECT_DOUBLE_EQ(look.shape.lengthM, 4.5);
    ASSERT_EQ(look.shape.axles.size(), 2U);
    EXPECT_TRUE(look.shape.axles[0].steers);
    EXPECT_FALSE(look.shape.axles[1].steers);
    EXPECT_GT(look.shape.blue, 2.0F * look.shape.red);
    EXPECT_NE(entityLook(vehicle("car", "car_red", {4.5, 1.8, 1.5})).shape, look.shape);
}

TEST(EntityLook, SaysWhenABoxCannotBeOfTheKind)
{
    const auto look = entityLook(vehicle("bus", "bus_blue", {4.5, 1.8, 1.5}));
    EXPECT_EQ(look.shape.kind, EntityKind::bus);
    EXPECT_GT(look.shape.lengthM, 10.0);
    EXPECT_EQ(look.note, "A: a bounding box of 4.5 m by 1.8 m by 1.5 m cannot be that of its category; it "
                         "is drawn 11.9 m long");
}

TEST(EntityLook, KindFollowsCategoryAndNames)
{
    EXPECT_EQ(entityLook(vehicle("truck", "semi_tractor", {6.0, 2.5, 3.6})).shape.kind, EntityKind::tractor);
    EXPECT_EQ(entityLook(vehicle("truck", "truck", {8.0, 2.5, 3.6})).shape.kind, EntityKind::lorry);
    EXPECT_EQ(entityLook(vehicle("trailer", "semi_trailer", {12.0, 2.5, 3.6})).shape.kind,
              EntityKind::semitrailer);
    EXPECT_EQ(kindOf<simulation::Pedestrian>("animal", "moose"), EntityKind::deer);
    EXPECT_EQ(kindOf<simulation::Pedestrian>("animal", "cow_brown"), EntityKind::cow);
    EXPECT_EQ(kindOf<simulation::Pedestrian>("animal", "sheep"), EntityKind::sheep);
    EXPECT_EQ(kindOf<simulation::Pedestrian>("pedestrian", "a_dog"), EntityKind::dog);
    EXPECT_EQ(kindOf<simulation::Pedestrian>("animal", "pony"), EntityKind::horse);
    EXPECT_EQ(kindOf<simulation::MiscObject>("none", "ferry"), EntityKind::ship);
    EXPECT_EQ(kindOf<simulation::Pedestrian>("pedestrian", "adult"), EntityKind::pedestrian);
    EXPECT_EQ(kindOf<simulation::MiscObject>("obstacle", "cone-45"), EntityKind::cone);
    EXPECT_EQ(kindOf<simulation::MiscObject>("barrier", "x"), EntityKind::barrier);
    EXPECT_EQ(kindOf<simulation::MiscObject>("obstacle", "box"), EntityKind::box);
    EXPECT_EQ(entityLook(vehicle("aircraft", "c172", {8.0, 11.0, 2.7})).shape.kind,
              EntityKind::lightAircraft);
    EXPECT_EQ(entityLook(vehicle("aircraft", "glider", {7.0, 15.0, 1.5})).shape.kind, EntityKind::glider);
    EXPECT_EQ(entityLook(vehicle("aircraft", "x", {37.0, 35.0, 12.0})).shape.kind, EntityKind::airliner);
    EXPECT_EQ(entityLook(vehicle("helicopter", "x", {11.0, 2.2, 3.2})).shape.kind, EntityKind::helicopter);
}

TEST(EntityLook, CarsDifferInColourAndBodyByTheirNames)
{
    std::set<std::tuple<float, float, float>> colours;
    std::set<scenery::models::CarBody> bodies;
    for (int i = 0; i < 40; ++i)
    {
        auto car = vehicle("car", "car", {4.5, 1.8, 1.5});
        car.name = "Target" + std::to_string(i);
        const auto shape = entityLook(car).shape;
        EXPECT_EQ(shape, entityLook(car).shape);
        colours.emplace(shape.red, shape.green, shape.blue);
        bodies.insert(shape.body);
    }
    EXPECT_GE(colours.size(), 6U);
    EXPECT_EQ(bodies.size(), 2U) << "saloons and estates";
    EXPECT_EQ(entityLook(vehicle("car", "car", {3.9, 1.7, 1.5})).shape.body,
              scenery::models::CarBody::hatchback);
    EXPECT_EQ(entityLook(vehicle("car", "car", {4.6, 1.9, 1.75})).shape.body, scenery::models::CarBody::suv);
    EXPECT_EQ(entityLook(vehicle("car", "sedan", {4.6, 1.9, 1.75})).shape.body,
              scenery::models::CarBody::saloon);
}
