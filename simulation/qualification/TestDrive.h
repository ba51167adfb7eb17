// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "simulation/vehicle/Ground.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/road/HandShift.h"
#include "simulation/vehicle/road/RoadVehicle.h"

namespace simulation
{

/// A vehicle on a proving ground: level ground of one kind, still air, heading east.
class TestDrive
{
public:
    TestDrive(std::shared_ptr<const RoadVehicleData> vehicle, std::shared_ptr<const Ground> ground,
              double speedMps);

    RoadVehicle& vehicle() { return _vehicle; }
    double speedMps() const { return _vehicle.readings().speedMps; }
    double timeS() const { return _vehicle.state().timeS; }
    void set(RoadInput input, double value) { _vehicle.inputs()[static_cast<std::size_t>(input)] = value; }

    void step() { _vehicle.step(*_ground, _air); }

    /// Holds a speed by the throttle for the next step.
    void holdSpeed(double speedMps);

    /// Full throttle from a standstill, shifting a manual gearbox, for the next step.
    void accelerate();

private:
    std::shared_ptr<const Ground> _ground;
    WeatherAir _air;
    RoadVehicle _vehicle;
    HandShift _hand;
    double _held = 0.0; ///< integral of the speed's difference
};

} // namespace simulation
