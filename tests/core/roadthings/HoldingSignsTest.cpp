// SPDX-License-Identifier: Apache-2.0
// Which signs stand before a runway, and where.
#include "scenery/structures/HoldingSigns.h"

#include <gtest/gtest.h>

#include "scenery/models/ModelCheck.h"
#include "scenery/roads/things/ThingObstacles.h"

namespace
{

using namespace scenery;
using osgTerrainROAM::core::HoldingPosition;

/// On a taxiway that leads north from the runway.
HoldingPosition northOf(double runwayM)
{
    return {{300.0, 75.0}, {0.0, 1.0}, 15.0, runwayM, "27-09"};
}

std::optional<double> flat(const glm::dvec2& place)
{
    return place.x < 5000.0 ? std::optional(12.0) : std::nullopt;
}

TEST(HoldingSigns, StandOnBothSidesAndFaceWhoWaits)
{
    for (const auto& [runwayM, fromEdgeM] : {std::pair{900.0, 5.0}, {2500.0, 11.0}})
    {
        const std::vector positions{northOf(runwayM)};
        const roads::RoadThings signs = holdingSigns(positions, {}, flat);
        ASSERT_EQ(signs.standing.size(), 2U);
        ASSERT_EQ(signs.models.size(), 1U);
        EXPECT_EQ(signs.models[0].text, "27-09");
        const double nearestM = 7.5 + fromEdgeM + 0.5 * signs.models[0].widthM;
        for (const roads::StandingThing& sign : signs.standing)
        {
            EXPECT_NEAR(std::abs(sign.position.x - 300.0), nearestM, 1e-9);
            EXPECT_EQ(sign.position.y, 75.0);
            EXPECT_EQ(sign.position.z, 12.0);
            EXPECT_EQ(sign.axes[0], glm::dvec3(0.0, -1.0, 0.0)) << "its face looks against x";
            EXPECT_NEAR(glm::determinant(sign.axes), 1.0, 1e-12);
        }
        simulation::ObstacleList obstacles;
        roads::addObstacles(signs, obstacles);
        EXPECT_EQ(obstacles.obstacles().size(), 4U) << "two legs each";
    }
}

TEST(HoldingSigns, NoneStandsOnPavingOnAnotherOrOffTheGround)
{
    std::vector positions{northOf(2500.0)};
    const PavedWay beside{{{322.0, -200.0}, {322.0, 400.0}}, 15.0};
    const auto signs = holdingSigns(positions, std::span(&beside, 1), flat);
    ASSERT_EQ(signs.standing.size(), 1U);
    EXPECT_LT(signs.standing[0].position.x, 300.0);
    positions.push_back(positions.front());
    EXPECT_EQ(holdingSigns(positions, {}, flat).standing.size(), 2U);
    positions = {northOf(2500.0)};
    positions[0].place.x = 6000.0;
    EXPECT_TRUE(holdingSigns(positions, {}, flat).standing.empty());
}

TEST(HoldingSigns, TheirModelsAreSoundAndWideEnoughForTheirText)
{
    for (const char* text : {"09", "09L-27R", "18C", ""})
    {
        models::RoadModel model;
        model.kind = models::RoadModel::Kind::runwaySign;
        model.postDepthM = models::kPostDepthM;
        model.text = text;
        const models::Model made = models::makeRoadModel(model);
        EXPECT_EQ(models::defectOf(made), "") << text;
        double widestM = 0.0, highestM = 0.0;
        for (const auto& position : made.mesh.positions)
        {
            widestM = std::max(widestM, std::abs(static_cast<double>(position.y)));
            highestM = std::max(highestM, static_cast<double>(position.z));
        }
        EXPECT_GT(2.0 * widestM, 0.35 * static_cast<double>(std::string(text).size()));
        EXPECT_NEAR(highestM, 1.1, 1e-3);
    }
}

} // namespace
