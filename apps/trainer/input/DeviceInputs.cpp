// SPDX-License-Identifier: Apache-2.0
#include "input/DeviceInputs.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace trainer
{

namespace
{

constexpr double kMoved = 0.004; ///< of an axis; less is noise

} // namespace

void DeviceInputs::applyAxes(const DeviceState& state, const DeviceMap& map, Seen& seen,
                             simulation::ManualController& manual) const
{
    for (const DeviceAxis& axis : map.axes)
    {
        const auto at = static_cast<std::size_t>(axis.axis);
        const int place = manual.axisOf(axis.input);
        if (at >= state.axes.size() || place < 0 || std::abs(state.axes[at] - seen.axes[at]) < kMoved)
            continue;
        const auto moved = static_cast<std::size_t>(place);
        const simulation::InputAxis& range = manual.axes()[moved];
        manual.put(moved, inputOf(axis, state.axes[at], range.least, range.most));
    }
    for (const DeviceAxis& axis : map.axes)
    {
        const auto at = static_cast<std::size_t>(axis.axis);
        if (at < state.axes.size() && std::abs(state.axes[at] - seen.axes[at]) >= kMoved)
            seen.axes[at] = state.axes[at];
    }
}

void DeviceInputs::applyButtons(const DeviceState& state, const DeviceMap& map, Seen& seen, SeatKeys& keys)
{
    for (const DeviceButton& button : map.buttons)
    {
        const auto at = static_cast<std::size_t>(button.button);
        if (at >= state.isPressed.size() || state.isPressed[at] == seen.isPressed[at]) continue;
        if (state.isPressed[at])
            keys.press(button.key);
        else
            keys.release(button.key);
    }
    seen.isPressed = state.isPressed;
}

/// Lets go of the buttons of devices that are gone; one that returns is seen anew.
void DeviceInputs::forgetGone(const std::vector<DeviceState>& states, SeatKeys& keys)
{
    for (auto seen = _seen.begin(); seen != _seen.end();)
    {
        const bool isThere = std::any_of(states.begin(), states.end(),
                                         [&](const DeviceState& state) { return state.name == seen->first; });
        const DeviceMap* const map = isThere ? nullptr : mapFor(_maps, seen->first);
        if (map)
        {
            DeviceState none{seen->first, {}, std::vector<bool>(seen->second.isPressed.size(), false)};
            applyButtons(none, *map, seen->second, keys);
        }
        seen = isThere ? std::next(seen) : _seen.erase(seen);
    }
}

void DeviceInputs::apply(const std::vector<DeviceState>& states, simulation::ManualController* manual,
                         SeatKeys& keys)
{
    forgetGone(states, keys);
    for (const DeviceState& state : states)
    {
        const DeviceMap* const map = mapFor(_maps, state.name);
        if (!map) continue;
        Seen& seen = _seen[state.name];
        seen.axes.resize(state.axes.size(), 0.0);
        seen.isPressed.resize(state.isPressed.size(), false);
        if (manual) applyAxes(state, *map, seen, *manual);
        applyButtons(state, *map, seen, keys);
    }
}

} // namespace trainer
