// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace trainer
{

/// What a key does.
enum class KeyAction
{
    hold, ///< moves an input of the vehicle while it is held
    add,  ///< moves one by an amount
    flip, ///< from one end of its range to the other
    help,
    statistics,
    instruments,
    fullscreen,
    picture,
    end,
    view, ///< `amount`: place in kSeatViews
    nextView,
    glance,    ///< turns the head while it is held; `amount`: degrees to the left
    leanAhead, ///< moves the head in its seat while it is held; `amount`: 1 or -1
    leanLeft,
    leanUp,
    zoom, ///< shows the middle of the picture larger while it is held; `amount`: doublings
    straighten,
    panel,     ///< the head reads the instruments, or looks out again
    altimeter, ///< sets it; `amount`: hPa more
    pause,
    step,
    slower,
    faster,
    realTime,
    reset,
    reposition,
    handOver
};

/// For whom a key is.
enum class KeyScope
{
    all,
    ride,   ///< whoever has a vehicle in hand
    flight, ///< an aircraft
    drive   ///< a road vehicle
};

/// A key and what it does. The same table handles the keys and writes the help.
struct KeyBinding
{
    std::string_view key; ///< of keyOf()
    KeyScope scope;
    KeyAction action;
    std::string_view input; ///< of the vehicle, with hold, add and flip
    double amount;          ///< direction, or how much
    std::string_view text;  ///< in the help
};

/// Every key. No key stands twice in what one vehicle sees.
std::span<const KeyBinding> keyTable();

/// Whether a action lasts while its key is held: its amount is then the sum of what is held, and 0 when
/// nothing is.
constexpr bool isHeld(KeyAction action)
{
    return action == KeyAction::hold || (action >= KeyAction::glance && action <= KeyAction::zoom);
}

/// Whether a binding is there for a vehicle of the kind `vehicle` (ride stands for none: then scope all alone
/// counts).
bool isFor(const KeyBinding& binding, KeyScope vehicle);

/// The views in the order of their keys, by the names of --eye.
inline constexpr std::string_view kSeatViews[] = {"own", "chase", "above", "tower", "kerb", "free", "map"};

} // namespace trainer
