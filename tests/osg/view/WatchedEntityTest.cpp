// SPDX-License-Identifier: Apache-2.0
#include "view/WatchedEntity.h"

#include <gtest/gtest.h>

using trainer::trainOf;
using trainer::watchedEntity;

namespace
{

simulation::ScenarioObject thing(const std::string& name)
{
    simulation::ScenarioObject object;
    object.name = name;
    object.object = simulation::MiscObject{};
    return object;
}

simulation::ScenarioObject vehicle(const std::string& name, const std::string& tows = "")
{
    simulation::Vehicle made;
    made.box = {{1.4, 0.0, 0.8}, 4.6, 1.8, 1.6}; // 0.9 m behind the origin
    made.trailerHitchDxM = -1.0;
    made.trailerCouplerDxM = 5.0;
    made.trailerEntity = tows;
    simulation::ScenarioObject object;
    object.name = name;
    object.object = made;
    return object;
}

std::size_t usual(std::vector<simulation::ScenarioObject> entities)
{
    simulation::Scenario scenario;
    scenario.entities = std::move(entities);
    return watchedEntity(scenario, "").value();
}

} // namespace

TEST(WatchedEntity, IsTheOwnOneElseTheFirstVehicleElseWhoeverMoves)
{
    simulation::ScenarioObject walker;
    walker.object = simulation::Pedestrian{};
    EXPECT_EQ(usual({thing("cone"), vehicle("lead"), vehicle("Ego")}), 2U);
    EXPECT_EQ(usual({thing("cone"), vehicle("lead")}), 1U);
    EXPECT_EQ(usual({vehicle("trailer"), vehicle("car", "trailer")}), 1U) << "the trailer has no driver";
    EXPECT_EQ(usual({thing("cone"), walker}), 1U);
    EXPECT_EQ(usual({thing("cone")}), 0U);
}

TEST(WatchedEntity, IsTheOneThatIsNamed)
{
    simulation::Scenario scenario;
    scenario.entities = {vehicle("Ego"), thing("cone")};
    EXPECT_EQ(watchedEntity(scenario, "cone").value(), 1U);
    const auto none = watchedEntity(scenario, "bus");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().remedy, "write one of: Ego, cone");
}

TEST(WatchedEntity, ATrainReachesToItsLastTrailer)
{
    simulation::Scenario scenario;
    scenario.entities = {vehicle("car", "first"), vehicle("first", "second"), vehicle("second"),
                         vehicle("alone")};
    // Each trailer's origin is 6 m behind that of what draws it; the last reaches 0.9 m behind its own.
    EXPECT_NEAR(trainOf(scenario, 0).behindM, 12.9, 1e-12);
    EXPECT_NEAR(trainOf(scenario, 1).behindM, 6.9, 1e-12);
    EXPECT_NEAR(trainOf(scenario, 3).behindM, 0.9, 1e-12);
    EXPECT_NEAR(trainOf(scenario, 0).heightM, 1.6, 1e-12);
    std::get<simulation::Vehicle>(scenario.entities[2].object).trailerEntity = "car"; // bites its tail
    EXPECT_NEAR(trainOf(scenario, 0).behindM, 12.9, 1e-12);
}
