// SPDX-License-Identifier: Apache-2.0
#include "input/DeviceHands.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace trainer
{

namespace
{

constexpr double kMoved = 0.004; ///< of an axis; less is noise

} // namespace

void DeviceHands::applyAxes(const DeviceState& state, const DeviceMap& map, Seen& seen,
                            simulation::Hands& hands) const
{
    for (const DeviceAxis& axis : map.axes)
    {
        const auto at = static_cast<std::size_t>(axis.axis);
        const int place = hands.axisOf(axis.input);
        if (at >= state.axes.size() || place < 0 || std::abs(state.axes[at] - seen.axes[at]) < kMoved)
            continue;
        const auto moved = static_cast<std::size_t>(place);
        const simulation::HandAxis& range = hands.axes()[moved];
        hands.put(moved, inputOf(axis, state.axes[at], range.least, range.most));
    }
    for (const DeviceAxis& axis : map.axes)
    {
        const auto at = static_cast<std::size_t>(axis.axis);
        if (at < state.axes.size() && std::abs(state.axes[at] - seen.axes[at]) >= kMoved)
            seen.axes[at] = state.axes[at];
    }
}

void DeviceHands::applyButtons(const DeviceState& state, const DeviceMap& map, Seen& seen, SeatKeys& keys)
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
void DeviceHands::forgetGone(const std::vector<DeviceState>& states, SeatKeys& keys)
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

void DeviceHands::apply(const std::vector<DeviceState>& states, simulation::Hands* hands, SeatKeys& keys)
{
    forgetGone(states, keys);
    for (const DeviceState& state : states)
    {
        const DeviceMap* const map = mapFor(_maps, state.name);
        if (!map) continue;
        Seen& seen = _seen[state.name];
        seen.axes.resize(state.axes.size(), 0.0);
        seen.isPressed.resize(state.isPressed.size(), false);
        if (hands) applyAxes(state, *map, seen, *hands);
        applyButtons(state, *map, seen, keys);
    }
}

} // namespace trainer
