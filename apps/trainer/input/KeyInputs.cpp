// SPDX-License-Identifier: Apache-2.0
#include "input/KeyInputs.h"

namespace trainer
{

namespace
{

constexpr std::string_view kBrakes[] = {"left_brake", "right_brake"};

} // namespace

void holdInput(simulation::ManualController& manual, std::string_view input, double direction)
{
    if (input == "brakes")
    {
        for (const std::string_view brake : kBrakes)
            holdInput(manual, brake, direction);
        return;
    }
    if (const int axis = manual.axisOf(input); axis >= 0)
        manual.hold(static_cast<std::size_t>(axis), direction);
}

void addToInput(simulation::ManualController& manual, std::string_view input, double amount)
{
    if (const int axis = manual.axisOf(input); axis >= 0) manual.add(static_cast<std::size_t>(axis), amount);
}

void flipInput(simulation::ManualController& manual, std::string_view input)
{
    const int axis = manual.axisOf(input);
    if (axis < 0) return;
    const auto at = static_cast<std::size_t>(axis);
    const simulation::InputAxis& range = manual.axes()[at];
    const bool isUp = manual.value(at) > 0.5 * (range.least + range.most);
    manual.put(at, isUp ? range.least : range.most);
}

} // namespace trainer
