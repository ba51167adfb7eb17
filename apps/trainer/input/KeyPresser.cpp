// SPDX-License-Identifier: Apache-2.0
#include "input/KeyPresser.h"

#include <algorithm>
#include <cmath>

#include "input/Keys.h"

namespace trainer
{

namespace
{

constexpr double kTrimmed = 0.02,
                 kTrimS = 1.5; ///< of the elevator that is wished for, in the mean of so long
constexpr double kPaid = 0.3;  ///< the share of a moment's lack that is made up for in the next

/// Where an axis is after a moment of being pushed so, without what speed takes from its reach.
double after(const simulation::InputAxis& axis, double value, double direction, double nextS)
{
    if (direction != 0.0)
        return std::clamp(value + direction * axis.perSecond * nextS, axis.least, axis.most);
    const double most = axis.returnPerSecond * nextS;
    return value + std::clamp(axis.rest - value, -most, most);
}

double nearestPush(const simulation::InputAxis& axis, double value, double wish, double nextS)
{
    double best = 0.0;
    for (const double direction : {1.0, -1.0})
        if (std::abs(after(axis, value, direction, nextS) - wish) <
            std::abs(after(axis, value, best, nextS) - wish) - 1e-9)
            best = direction;
    return best;
}

/// The input that the table names for one of the vehicle: one key is for both brakes.
std::string_view keyedInput(std::string_view input)
{
    return input == "left_brake" ? "brakes" : input;
}

} // namespace

/// Towards the elevator that would be held for long.
double KeyPresser::trimDirection(double elevator, double nextS)
{
    _elevator += (elevator - _elevator) * std::min(1.0, nextS / kTrimS);
    return std::abs(_elevator) < kTrimmed ? 0.0 : std::copysign(1.0, _elevator);
}

/// The wish and what it is owed where an input springs back: pushes are steps, so that it is right in the
/// mean alone.
double KeyPresser::owing(const simulation::InputAxis& axis, double wish, double value, double nextS)
{
    if (axis.returnPerSecond <= 0.0) return wish;
    const double step = axis.perSecond * nextS;
    double& owed = _owed[axis.input];
    owed = std::clamp(owed + kPaid * (wish - value), -step, step);
    return wish + owed;
}

void KeyPresser::push(std::string_view input, double direction, std::vector<KeyStroke>& strokes)
{
    double& before = _pushed[input];
    if (before == direction) return;
    for (const KeyBinding& binding : keyTable())
    {
        if (binding.action != KeyAction::hold || binding.input != input || !isFor(binding, _vehicle))
            continue;
        if (binding.amount == before) strokes.push_back({*keyOf(binding.key), false});
        if (binding.amount == direction) strokes.push_back({*keyOf(binding.key), true});
    }
    before = direction;
}

/// Taps the key that adds most nearly what is missing, if one does.
void KeyPresser::add(std::string_view input, double missing, std::vector<KeyStroke>& strokes) const
{
    for (const KeyBinding& binding : keyTable())
    {
        if (binding.action != KeyAction::add || binding.input != input || !isFor(binding, _vehicle)) continue;
        if (std::abs(missing - binding.amount) > std::abs(missing) - 1e-9) continue;
        strokes.push_back({*keyOf(binding.key), true});
        strokes.push_back({*keyOf(binding.key), false});
        return;
    }
}

std::vector<KeyStroke> KeyPresser::decide(const simulation::ManualController& manual,
                                          std::span<const double> wishes,
                                          std::span<const std::string_view> names, double nextS)
{
    std::vector<KeyStroke> strokes;
    for (std::size_t i = 0; i < wishes.size() && i < names.size(); ++i)
    {
        const int at = manual.axisOf(names[i]);
        if (at < 0) continue;
        const auto place = static_cast<std::size_t>(at);
        const simulation::InputAxis& axis = manual.axes()[place];
        const double value = manual.value(place);
        if (names[i] == "gear") continue; // forward from the start; the left foot shifts
        if (names[i] == "elevator") push("elevator_trim", trimDirection(wishes[i], nextS), strokes);
        if (names[i] == "elevator_trim") continue;
        add(names[i], wishes[i] - value, strokes);
        push(keyedInput(names[i]), nearestPush(axis, value, owing(axis, wishes[i], value, nextS), nextS),
             strokes);
    }
    return strokes;
}

} // namespace trainer
