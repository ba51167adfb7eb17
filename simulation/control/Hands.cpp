// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/Hands.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

foundation::Result<Hands> Hands::create(std::vector<HandAxis> axes, const DynamicVehicle& vehicle)
{
    Hands hands(std::move(axes));
    hands._stepS = vehicle.stepSeconds();
    const std::span<const std::string_view> names = vehicle.inputNames();
    for (std::size_t i = 0; i < hands._axes.size(); ++i)
    {
        const auto found = std::find(names.begin(), names.end(), hands._axes[i].input);
        if (found == names.end())
            return foundation::Error{std::string(hands._axes[i].input), "the vehicle has no such input",
                                     "control another"};
        hands._hands[i].place = static_cast<std::size_t>(found - names.begin());
    }
    return hands;
}

void Hands::take(std::span<const double> inputs, bool isStart)
{
    for (std::size_t i = 0; i < _hands.size(); ++i)
    {
        if (isStart && _hands[i].isPut) continue;
        const double now = inputs[_hands[i].place];
        _hands[i].value = isStart ? _axes[i].start.value_or(now) : now;
        _hands[i].isPut = false;
    }
}

void Hands::hold(std::size_t axis, double direction)
{
    _hands[axis].direction = direction;
    if (direction != 0.0) _hands[axis].isPut = false;
}

void Hands::put(std::size_t axis, double value)
{
    if (!std::isfinite(value)) return;
    _hands[axis].value = std::clamp(value, _axes[axis].least, _axes[axis].most);
    _hands[axis].isPut = true;
}

void Hands::add(std::size_t axis, double amount)
{
    Hand& hand = _hands[axis];
    hand.value = std::clamp(hand.value + amount, _axes[axis].least, _axes[axis].most);
}

/// Towards where held keys push it, or back to rest.
void Hands::move(const HandAxis& axis, Hand& hand, double speedMps, double stepS) const
{
    if (hand.isPut) return;
    double reach = 1.0;
    if (axis.softMps > 0.0 && speedMps > axis.softMps)
        reach = std::min(1.0, axis.softMps * axis.softMps / (speedMps * speedMps) + axis.softLeast);
    const auto towards = [&](double target, double perSecond)
    { hand.value += std::clamp(target - hand.value, -perSecond * stepS, perSecond * stepS); };
    if (hand.direction != 0.0)
        towards(axis.rest + reach * ((hand.direction > 0.0 ? axis.most : axis.least) - axis.rest),
                axis.perSecond * std::abs(hand.direction));
    else if (axis.returnPerSecond > 0.0)
        towards(axis.rest, axis.returnPerSecond);
}

void Hands::control(const ControlView& view, std::span<double> inputs)
{
    const double speedMps = glm::length(view.state.velocity);
    for (std::size_t i = 0; i < _hands.size(); ++i)
    {
        move(_axes[i], _hands[i], speedMps, _stepS);
        inputs[_hands[i].place] = _hands[i].value;
    }
    if (_finish) _finish(inputs);
}

int Hands::axisOf(std::string_view input) const
{
    const auto found =
        std::find_if(_axes.begin(), _axes.end(), [&](const HandAxis& axis) { return axis.input == input; });
    return found == _axes.end() ? -1 : static_cast<int>(found - _axes.begin());
}

} // namespace simulation
