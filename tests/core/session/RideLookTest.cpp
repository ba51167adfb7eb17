// SPDX-License-Identifier: Apache-2.0
// The scenario of a drive names the look that the vehicle's file names.
#include <gtest/gtest.h>

#include "osgSession/src/core/RideScenario.h"

namespace
{

std::string modelOf(const std::filesystem::path& look)
{
    auto data = simulation::readRoadVehicle(OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml");
    EXPECT_TRUE(data) << (data ? "" : data.error().message());
    if (!data) return {};
    data->lookFile = look;
    return osgSession::core::driveScenario(*data, {}, std::nullopt, {}).entities.front().model3d();
}

} // namespace

TEST(RideLook, IsNamedFromEveryFolder)
{
    EXPECT_EQ(modelOf(""), "");
    EXPECT_EQ(modelOf("/cars/mine.json"), "/cars/mine.json");
    // A ride is shown from the folder of its world, the file is named from where the program runs.
    EXPECT_EQ(modelOf("cars/mine.json"), (std::filesystem::current_path() / "cars/mine.json").string());
}
