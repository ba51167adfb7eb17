// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/Drivetrain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simulation
{

namespace
{

constexpr double kRadpsPerRpm = std::numbers::pi / 30.0;
constexpr double kFadeRpm = 250.0; ///< above the limit, in which the torque ends
constexpr double kIdleBand = 0.1;  ///< of the idle speed, below which the governor gives all it may
constexpr double kIdleMost = 0.6;  ///< of the full torque, for the governor
constexpr double kFullyPressed = 0.95;

double mix(double first, double second, double share)
{
    return first + share * (second - first);
}

} // namespace

void Drivetrain::reset()
{
    _state = {};
    _isBroken = false;
    _state.engineRadps = _vehicle.engine.idleRpm * kRadpsPerRpm;
}

void Drivetrain::begin(double shaftRadps)
{
    reset();
    const RoadEngineData& engine = _vehicle.engine;
    if (shaftRadps < 1.0) return;
    const int most = static_cast<int>(_vehicle.gearbox.ratios.size());
    int gear = 1;
    while (gear < most && shaftRadps * ratioOf(gear) > 0.6 * engine.limitRpm * kRadpsPerRpm)
        ++gear;
    _state.gear = _state.lastGear = gear;
    _state.engineRadps =
        std::clamp(shaftRadps * ratioOf(gear), engine.idleRpm * kRadpsPerRpm, engine.limitRpm * kRadpsPerRpm);
}

bool Drivetrain::isFinite() const
{
    return std::isfinite(_state.engineRadps) && std::isfinite(_state.torqueShare);
}

double Drivetrain::ratioOf(int gear) const
{
    const GearboxData& box = _vehicle.gearbox;
    if (gear == 0) return 0.0;
    const double ratio = gear < 0 ? -box.reverseRatio : box.ratios[static_cast<std::size_t>(gear - 1)];
    return ratio * box.finalRatio;
}

/// The ratio of the gear, or of the shift under way.
double Drivetrain::ratioNow() const
{
    const double ratio = ratioOf(_state.gear), last = ratioOf(_state.lastGear);
    if (_state.shiftingS <= 0.0 || !_vehicle.gearbox.isAutomatic || ratio * last <= 0.0) return ratio;
    return mix(ratio, last, std::min(1.0, _state.shiftingS / _vehicle.gearbox.shiftS));
}

void Drivetrain::shiftTo(int gear)
{
    if (gear == _state.gear) return;
    _state.lastGear = _state.gear;
    _state.gear = gear;
    _state.shiftingS = _vehicle.gearbox.shiftS;
    _state.isLockedUp = false;
}

void Drivetrain::chooseAutomatic(double throttle, double shaftRadps)
{
    const GearboxData& box = _vehicle.gearbox;
    const int most = static_cast<int>(box.ratios.size());
    const double rpm = shaftRadps * ratioOf(_state.gear) / kRadpsPerRpm;
    if (_state.gear < most && rpm > mix(box.upIdleRpm, box.upFullRpm, throttle))
        shiftTo(_state.gear + 1);
    else if (_state.gear > 1 && rpm < mix(box.downIdleRpm, box.downFullRpm, throttle))
    {
        // Not into a gear that would shift up again at once.
        const double lower = shaftRadps * ratioOf(_state.gear - 1) / kRadpsPerRpm;
        if (lower < mix(box.upIdleRpm, box.upFullRpm, throttle)) shiftTo(_state.gear - 1);
    }
}

void Drivetrain::choose(const RoadInputs& inputs, double shaftRadps, double stepS)
{
    const GearboxData& box = _vehicle.gearbox;
    const int most = static_cast<int>(box.ratios.size());
    const int wanted = std::min(static_cast<int>(inputOf(inputs, RoadInput::gear)), most);
    _state.shiftingS = std::max(0.0, _state.shiftingS - stepS);
    const double clutch = inputOf(inputs, RoadInput::clutch);
    if (!box.isAutomatic)
    {
        // The lever moves with a pressed clutch alone, into neutral always.
        if (wanted != _state.gear && (wanted == 0 || clutch > 0.5)) shiftTo(wanted);
    }
    else if (wanted <= 0 || _state.gear <= 0)
        shiftTo(std::min(wanted, 1));
    else if (_state.shiftingS <= 0.0)
        chooseAutomatic(inputOf(inputs, RoadInput::throttle), shaftRadps);
    const bool isFree = _state.gear == 0 || (!box.isAutomatic && clutch > kFullyPressed);
    if (_state.isStalled && isFree && !_isBroken)
    {
        _state.isStalled = false;
        _state.engineRadps = _vehicle.engine.idleRpm * kRadpsPerRpm;
    }
    if (!box.isAutomatic || box.converter.lockupNm <= 0.0) return;
    const double ratio = shaftRadps * ratioNow() / std::max(_state.engineRadps, 1.0);
    if (_state.gear < box.converter.lockupFromGear || _state.shiftingS > 0.0 ||
        ratio < box.converter.lockupRatio - 0.2)
        _state.isLockedUp = false;
    else if (ratio > box.converter.lockupRatio)
        _state.isLockedUp = true;
}

double Drivetrain::engineTorque(double throttle) const
{
    const RoadEngineData& engine = _vehicle.engine;
    const double rpm = _state.engineRadps / kRadpsPerRpm;
    const double drag = engine.dragTorqueNm.at(rpm);
    if (_state.isStalled) return -drag;
    const double full = engine.fullTorqueNm.at(rpm) + drag;
    const double below = (engine.idleRpm - rpm) / (kIdleBand * engine.idleRpm);
    // The governor holds against the engine's own drag at idle, and gives more below.
    const double held = full > 0.0 ? std::clamp(drag / full + below, 0.0, kIdleMost) : 0.0;
    const double governor = rpm < engine.idleRpm * (1.0 + kIdleBand) ? held : 0.0;
    const double fade = std::clamp((engine.limitRpm + kFadeRpm - rpm) / kFadeRpm, 0.0, 1.0);
    return full * std::max(throttle * fade, governor) - drag;
}

/// Torque through a friction clutch: what makes both sides turn alike, within what it carries.
double Drivetrain::clutchTorque(double mostNm, double engineNm, double inputRadps, double inputInertia,
                                double stepS)
{
    const double engineInertia = _vehicle.engine.inertiaKgM2;
    const double apart = _state.engineRadps + stepS * engineNm / engineInertia - inputRadps;
    const double alike = apart / stepS * engineInertia * inputInertia / (engineInertia + inputInertia);
    return std::clamp(alike, -mostNm, mostNm);
}

/// Torque of the pump; `turbineNm` becomes that of the turbine.
double Drivetrain::converterTorque(double inputRadps, double& turbineNm) const
{
    const ConverterData& converter = _vehicle.gearbox.converter;
    const double engine = std::max(_state.engineRadps, 1.0);
    const double ratio = std::clamp(inputRadps / engine, -1.0, 3.0);
    // Driven by the wheels the parts change places.
    const double fast = std::max(engine, inputRadps);
    const double slow = ratio <= 1.0 ? ratio : 1.0 / ratio;
    const double pump = converter.torqueFactor.at(slow) * fast * fast;
    turbineNm = ratio <= 1.0 ? pump * converter.torqueRatio.at(slow) : -pump;
    return ratio <= 1.0 ? pump : -pump;
}

double Drivetrain::drive(const RoadInputs& inputs, double shaftRadps, double wheelsInertiaKgM2, double stepS)
{
    const RoadEngineData& engine = _vehicle.engine;
    const GearboxData& box = _vehicle.gearbox;
    const bool isShifting = _state.shiftingS > 0.0 && box.isAutomatic;
    const double pedal =
        _state.isStalled ? 0.0 : inputOf(inputs, RoadInput::throttle) * (isShifting ? 0.5 : 1.0);
    _state.torqueShare += (pedal - _state.torqueShare) * stepS / (engine.lagS + stepS);
    const double engineNm = engineTorque(_state.torqueShare);
    const double ratio = ratioNow();
    double pumpNm = 0.0, turbineNm = 0.0;
    if (ratio != 0.0)
    {
        const double inputRadps = shaftRadps * ratio;
        const double inputInertia = box.inertiaKgM2 + wheelsInertiaKgM2 / (ratio * ratio);
        if (!box.isAutomatic)
        {
            const double carries = box.clutchNm * (1.0 - inputOf(inputs, RoadInput::clutch));
            pumpNm = turbineNm = clutchTorque(carries, engineNm, inputRadps, inputInertia, stepS);
        }
        else
        {
            pumpNm = converterTorque(inputRadps, turbineNm);
            if (_state.isLockedUp)
            {
                const double locked =
                    clutchTorque(box.converter.lockupNm, engineNm - pumpNm, inputRadps, inputInertia, stepS);
                pumpNm += locked;
                turbineNm += locked;
            }
        }
    }
    _state.engineRadps += stepS * (engineNm - pumpNm) / engine.inertiaKgM2;
    _state.engineRadps = std::clamp(_state.engineRadps, 0.0, 2.0 * engine.limitRpm * kRadpsPerRpm);
    if (!box.isAutomatic && _state.engineRadps < engine.stallRpm * kRadpsPerRpm) _state.isStalled = true;
    return turbineNm * ratio * box.efficiency;
}

} // namespace simulation
