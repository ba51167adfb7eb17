// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "simulation/control/driver/Driver.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/road/RoadVehicle.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"

namespace testsupport
{

/// A driver at the wheel of a vehicle of the tree, at the start of a way.
class Ride
{
public:
    Ride(const std::string& name, simulation::DriverPath path,
         std::shared_ptr<const simulation::Ground> ground, double speedMps = 0.0,
         const simulation::DriverSettings& settings = {})
        : _ground(std::move(ground)), _vehicle(dataOf(name)), _driver(_vehicle, std::move(path), settings)
    {
        _vehicle.place({_driver.path().placeAt(0.5), _driver.path().headingRadAt(0.5), speedMps}, *_ground);
    }

    void step(const simulation::Traffic& traffic = {})
    {
        const simulation::VehicleState state = _vehicle.state();
        _driver.control({state, _vehicle.status(), *_ground, _air, traffic, _steps, state.timeS},
                        _vehicle.inputs());
        _vehicle.step(*_ground, _air);
        ++_steps;
    }

    simulation::RoadVehicle& vehicle() { return _vehicle; }
    simulation::Driver& driver() { return _driver; }
    double speedMps() const { return _vehicle.readings().speedMps; }
    double timeS() const { return _vehicle.state().timeS; }

private:
    static std::shared_ptr<const simulation::RoadVehicleData> dataOf(const std::string& name)
    {
        const auto read =
            simulation::readRoadVehicle(OSGTRAINER_SOURCE_DIR "/data/vehicles/" + name + ".xml");
        EXPECT_TRUE(read) << (read ? "" : read.error().message());
        return std::make_shared<const simulation::RoadVehicleData>(*read);
    }

    std::shared_ptr<const simulation::Ground> _ground;
    simulation::WeatherAir _air;
    simulation::RoadVehicle _vehicle;
    simulation::Driver _driver;
    std::int64_t _steps = 0;
};

} // namespace testsupport
