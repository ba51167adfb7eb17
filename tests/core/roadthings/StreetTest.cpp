// SPDX-License-Identifier: Apache-2.0
// data/street.xodr has one of nearly everything: all of it is drawn, and every body is sound.
#include <gtest/gtest.h>

#include <osgRoads/core/read/ReadNetwork.h>

#include "scenery/models/ModelCheck.h"
#include "scenery/roads/things/CountThings.h"
#include "scenery/roads/things/RoadThings.h"

namespace roads = scenery::roads;

TEST(Street, IsDrawnAsAWhole)
{
    const auto read = osgRoads::core::readNetwork(OSGTRAINER_STREET);
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_TRUE(read->problems.empty());
    const auto network = std::make_shared<const osgRoads::core::RoadNetwork>(read->network);
    EXPECT_TRUE(roads::countThings(*network).withoutModel.empty());
    const roads::RoadThings things =
        roads::placeRoadThings(osgRoads::core::PlacedNetwork(network), [](const glm::dvec2&) { return 0.0; });
    EXPECT_GT(things.standing.size(), 60U);
    EXPECT_GT(things.lamps.size(), 7U);
    for (const auto& own : things.own)
        EXPECT_EQ(scenery::models::defectOf(own.model), "");
    for (const auto& model : things.models)
        EXPECT_EQ(scenery::models::defectOf(scenery::models::makeRoadModel(model)), "");
    for (const auto& thing : things.standing)
        EXPECT_LT(thing.model, things.models.size());
}
