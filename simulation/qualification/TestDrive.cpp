// SPDX-License-Identifier: Apache-2.0
#include "simulation/qualification/TestDrive.h"

#include <algorithm>

namespace simulation
{

namespace
{

constexpr double kDriveSettleS = 1.0;

} // namespace

TestDrive::TestDrive(std::shared_ptr<const RoadVehicleData> vehicle, std::shared_ptr<const Ground> ground,
                     double speedMps)
    : _ground(std::move(ground)), _vehicle(std::move(vehicle))
{
    _vehicle.place({{0.0, 0.0, 0.0}, 0.0, speedMps}, *_ground);
    _hand.begin(_vehicle);
    set(RoadInput::gear, std::max(1, _vehicle.readings().gear));
    set(RoadInput::clutch, speedMps > 0.0 ? 0.0 : 1.0);
    set(RoadInput::brake, speedMps > 0.0 ? 0.0 : 1.0);
    for (double left = kDriveSettleS; left > 0.0; left -= RoadVehicle::kStepS)
    {
        if (speedMps > 0.0) holdSpeed(speedMps);
        step();
    }
    set(RoadInput::brake, 0.0);
}

void TestDrive::holdSpeed(double speedMps)
{
    const double missing = speedMps - this->speedMps();
    _held = std::clamp(_held + missing * RoadVehicle::kStepS, -5.0, 5.0);
    set(RoadInput::throttle, std::clamp(0.3 * missing + 0.15 * _held, 0.0, 1.0));
}

void TestDrive::accelerate()
{
    _hand.control(_vehicle, 1.0, _vehicle.roadInputs());
}

} // namespace simulation
