// SPDX-License-Identifier: Apache-2.0
#include "input/HandInputs.h"

namespace trainer
{

namespace
{

constexpr std::string_view kBrakes[] = {"left_brake", "right_brake"};

} // namespace

void holdInput(simulation::Hands& hands, std::string_view input, double direction)
{
    if (input == "brakes")
    {
        for (const std::string_view brake : kBrakes)
            holdInput(hands, brake, direction);
        return;
    }
    if (const int axis = hands.axisOf(input); axis >= 0)
        hands.hold(static_cast<std::size_t>(axis), direction);
}

void addToInput(simulation::Hands& hands, std::string_view input, double amount)
{
    if (const int axis = hands.axisOf(input); axis >= 0) hands.add(static_cast<std::size_t>(axis), amount);
}

void flipInput(simulation::Hands& hands, std::string_view input)
{
    const int axis = hands.axisOf(input);
    if (axis < 0) return;
    const auto at = static_cast<std::size_t>(axis);
    const simulation::HandAxis& range = hands.axes()[at];
    const bool isUp = hands.value(at) > 0.5 * (range.least + range.most);
    hands.put(at, isUp ? range.least : range.most);
}

} // namespace trainer
