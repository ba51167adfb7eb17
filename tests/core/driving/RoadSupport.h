// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/road/RoadVehicle.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"

namespace testsupport
{

inline constexpr const char* kVehicleNames[] = {"car", "van", "bus"};

inline std::string vehicleFile(const std::string& name)
{
    return OSGTRAINER_SOURCE_DIR "/data/vehicles/" + name + ".xml";
}

/// A vehicle of the tree; a file that cannot be read fails the test.
inline std::shared_ptr<const simulation::RoadVehicleData> roadVehicle(const std::string& name = "car")
{
    const auto read = simulation::readRoadVehicle(vehicleFile(name));
    EXPECT_TRUE(read) << (read ? "" : read.error().message());
    return read ? std::make_shared<const simulation::RoadVehicleData>(*read) : nullptr;
}

inline void setInput(simulation::RoadVehicle& vehicle, simulation::RoadInput input, double value)
{
    vehicle.inputs()[static_cast<std::size_t>(input)] = value;
}

inline void stepFor(simulation::RoadVehicle& vehicle, const simulation::Ground& ground, double seconds)
{
    const simulation::WeatherAir air;
    for (double left = seconds; left > 1e-9; left -= simulation::RoadVehicle::kStepS)
        vehicle.step(ground, air);
}

} // namespace testsupport
