// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/ManualController.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

namespace
{

constexpr double kMovedShare = 0.02; ///< of an axis' range: less of a pedal is nobody's foot
constexpr double kStandsMps = 0.5;   ///< faster, a vehicle that begins is not parked

} // namespace

foundation::Result<ManualController> ManualController::create(std::vector<InputAxis> axes,
                                                              const DynamicVehicle& vehicle)
{
    ManualController manual(std::move(axes));
    manual._stepS = vehicle.stepSeconds();
    const std::span<const std::string_view> names = vehicle.inputNames();
    for (std::size_t i = 0; i < manual._axes.size(); ++i)
    {
        const auto found = std::find(names.begin(), names.end(), manual._axes[i].input);
        if (found == names.end())
            return foundation::Error{std::string(manual._axes[i].input), "the vehicle has no such input",
                                     "control another"};
        manual._states[i].place = static_cast<std::size_t>(found - names.begin());
    }
    return manual;
}

void ManualController::takeOver(std::span<const double> inputs, bool isStart)
{
    _isParked = isStart && _releases;
    for (std::size_t i = 0; i < _states.size(); ++i)
    {
        if (isStart && _states[i].isPut) continue;
        const double now = inputs[_states[i].place];
        _states[i].value = isStart ? _axes[i].start.value_or(now) : now;
        _states[i].isPut = false;
    }
}

void ManualController::hold(std::size_t axis, double direction)
{
    _states[axis].direction = direction;
    if (direction != 0.0) _states[axis].isPut = false;
}

void ManualController::put(std::size_t axis, double value)
{
    if (!std::isfinite(value)) return;
    _states[axis].value = std::clamp(value, _axes[axis].least, _axes[axis].most);
    _states[axis].isPut = true;
}

void ManualController::add(std::size_t axis, double amount)
{
    AxisState& state = _states[axis];
    state.value = std::clamp(state.value + amount, _axes[axis].least, _axes[axis].most);
}

/// Towards where held keys push it, or back to rest.
void ManualController::move(const InputAxis& axis, AxisState& state, double speedMps, double stepS) const
{
    if (state.isPut) return;
    double reach = 1.0;
    if (axis.softMps > 0.0 && speedMps > axis.softMps)
        reach = std::min(1.0, axis.softMps * axis.softMps / (speedMps * speedMps) + axis.softLeast);
    const auto towards = [&](double target, double perSecond)
    { state.value += std::clamp(target - state.value, -perSecond * stepS, perSecond * stepS); };
    if (state.direction != 0.0)
        towards(axis.rest + reach * ((state.direction > 0.0 ? axis.most : axis.least) - axis.rest),
                axis.perSecond * std::abs(state.direction));
    else if (axis.returnPerSecond > 0.0)
        towards(axis.rest, axis.returnPerSecond);
}

void ManualController::control(const ControlView& view, std::span<double> inputs)
{
    const double speedMps = glm::length(view.state.velocity);
    for (std::size_t i = 0; i < _states.size(); ++i)
    {
        move(_axes[i], _states[i], speedMps, _stepS);
        inputs[_states[i].place] = _states[i].value;
    }
    if (view.step == 0 && speedMps > kStandsMps) _isParked = false;
    if (_isParked) park(inputs);
    if (_finish) _finish(inputs);
}

/// Holds what parks the vehicle, unless the axis that releases it was moved.
void ManualController::park(std::span<double> inputs)
{
    const InputAxis& releases = _axes[*_releases];
    const double moved = std::abs(_states[*_releases].value - releases.rest);
    _isParked = moved <= kMovedShare * (releases.most - releases.least);
    for (std::size_t i = 0; i < _states.size() && _isParked; ++i)
        if (_axes[i].parked) inputs[_states[i].place] = *_axes[i].parked;
}

int ManualController::axisOf(std::string_view input) const
{
    const auto found =
        std::find_if(_axes.begin(), _axes.end(), [&](const InputAxis& axis) { return axis.input == input; });
    return found == _axes.end() ? -1 : static_cast<int>(found - _axes.begin());
}

} // namespace simulation
