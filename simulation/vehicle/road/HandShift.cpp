// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/HandShift.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

namespace
{

constexpr double kLateShare = 0.93; ///< of the limit, at full throttle
constexpr double kEarlyShare = 0.5; ///< at no throttle
constexpr double kLowShare = 1.5;   ///< of idle, at which a lower gear is taken
constexpr double kClosingS = 0.25;  ///< of the clutch, after a shift

} // namespace

double HandShift::clutchAt(double rpm, const RoadEngineData& engine)
{
    return 1.0 - std::clamp((rpm - 1.05 * engine.idleRpm) / (1.1 * engine.idleRpm), 0.0, 1.0);
}

void HandShift::begin(const RoadVehicle& vehicle)
{
    _gear = std::max(1, vehicle.readings().gear);
    _shiftS = 0.0;
}

int HandShift::chooseGear(const RoadVehicle& vehicle, double throttle) const
{
    const RoadReadings readings = vehicle.readings();
    const RoadEngineData& engine = vehicle.data().engine;
    const std::vector<double>& ratios = vehicle.data().gearbox.ratios;
    const auto ratio = [&](int gear) { return ratios[static_cast<std::size_t>(gear - 1)]; };
    const double upRpm = engine.limitRpm * (kEarlyShare + (kLateShare - kEarlyShare) * throttle);
    const double lowRpm = engine.idleRpm * kLowShare;
    const bool isClosed = readings.gear == _gear && readings.speedMps > 2.0;
    if (isClosed && _gear < static_cast<int>(ratios.size()) && readings.engineRpm > upRpm &&
        readings.engineRpm * ratio(_gear + 1) / ratio(_gear) > lowRpm)
        return _gear + 1;
    if (_gear > 1 && readings.engineRpm < lowRpm)
    {
        int lower = _gear - 1;
        while (lower > 1 && readings.engineRpm * ratio(lower) / ratio(_gear) < lowRpm)
            --lower;
        return readings.speedMps < 2.0 ? 1 : lower;
    }
    return _gear;
}

void HandShift::control(const RoadVehicle& vehicle, double throttle, RoadInputs& inputs)
{
    const GearboxData& box = vehicle.data().gearbox;
    const auto set = [&](RoadInput input, double value) { inputs[static_cast<std::size_t>(input)] = value; };
    set(RoadInput::throttle, throttle);
    set(RoadInput::gear, _gear);
    set(RoadInput::clutch, 0.0);
    if (box.isAutomatic) return;
    _shiftS = std::max(0.0, _shiftS - RoadVehicle::kStepS);
    if (_shiftS == 0.0)
    {
        const int gear = chooseGear(vehicle, throttle);
        if (gear != _gear) _shiftS = box.shiftS + kClosingS;
        _gear = gear;
    }
    set(RoadInput::gear, _gear);
    if (_shiftS > kClosingS)
    {
        set(RoadInput::throttle, 0.0);
        set(RoadInput::clutch, 1.0);
        return;
    }
    const double pedal = clutchAt(vehicle.readings().engineRpm, vehicle.data().engine);
    set(RoadInput::clutch, std::max(pedal, _shiftS / kClosingS));
    if (throttle <= 0.0 && _gear == 1 && vehicle.readings().speedMps < 2.0) set(RoadInput::clutch, 1.0);
}

} // namespace simulation
