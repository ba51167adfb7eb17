// SPDX-License-Identifier: Apache-2.0
#include "input/KeyTable.h"

#include <array>

namespace trainer
{

namespace
{

using enum KeyAction;
using Scope = KeyScope;

constexpr std::array kBindings{
    KeyBinding{"F1", Scope::all, help, "", 0.0, "this help"},
    KeyBinding{"F2", Scope::all, statistics, "", 0.0, "statistics"},
    KeyBinding{"F3", Scope::ride, instruments, "", 0.0, "instruments in the picture"},
    KeyBinding{"F11", Scope::all, fullscreen, "", 0.0, "whole screen, or a window again"},
    KeyBinding{"F12", Scope::all, picture, "", 0.0, "write the picture to a file"},
    KeyBinding{"Escape", Scope::all, end, "", 0.0, "end"},
    KeyBinding{"1", Scope::all, view, "", 0.0, "view of the driver or pilot"},
    KeyBinding{"2", Scope::all, view, "", 1.0, "view from behind"},
    KeyBinding{"3", Scope::all, view, "", 2.0, "view from above"},
    KeyBinding{"4", Scope::all, view, "", 3.0, "view from a tower"},
    KeyBinding{"5", Scope::all, view, "", 4.0, "view from the kerb"},
    KeyBinding{"6", Scope::all, view, "", 5.0, "free view: mouse and wheel move"},
    KeyBinding{"7", Scope::all, view, "", 6.0, "map, north up; wheel: scale"},
    KeyBinding{"v", Scope::all, nextView, "", 0.0, "next view"},
    KeyBinding{"q", Scope::all, glance, "", 60.0, "look left while held"},
    KeyBinding{"e", Scope::all, glance, "", -60.0, "look right while held"},
    KeyBinding{"c", Scope::all, glance, "", 180.0, "look back while held"},
    KeyBinding{"u", Scope::all, leanAhead, "", 1.0, "head forward, in the seat"},
    KeyBinding{"n", Scope::all, leanAhead, "", -1.0, "head back"},
    KeyBinding{"h", Scope::all, leanLeft, "", 1.0, "head to the left"},
    KeyBinding{"l", Scope::all, leanLeft, "", -1.0, "head to the right"},
    KeyBinding{"t", Scope::all, leanUp, "", 1.0, "head up"},
    KeyBinding{"b", Scope::all, leanUp, "", -1.0, "head down"},
    KeyBinding{"r", Scope::all, zoom, "", 2.0, "binoculars, while held"},
    KeyBinding{"o", Scope::all, straighten, "", 0.0, "head straight ahead again"},
    KeyBinding{"m", Scope::ride, panel, "", 0.0, "close to the dials, or away"},
    KeyBinding{"p", Scope::all, pause, "", 0.0, "pause, or go on"},
    KeyBinding{"Period", Scope::all, step, "", 0.0, "one step"},
    KeyBinding{"Minus", Scope::all, slower, "", 0.0, "half as fast"},
    KeyBinding{"Equal", Scope::all, faster, "", 0.0, "twice as fast"},
    KeyBinding{"0", Scope::all, realTime, "", 0.0, "real time"},
    KeyBinding{"BackSpace", Scope::all, reset, "", 0.0, "from the start again"},
    KeyBinding{"Home", Scope::ride, reposition, "", 0.0, "begin at the next place"},
    KeyBinding{"Tab", Scope::ride, handOver, "", 0.0, "take over, or give back"},
    KeyBinding{"Up", Scope::flight, hold, "elevator", 1.0, "stick forward"},
    KeyBinding{"Down", Scope::flight, hold, "elevator", -1.0, "stick back"},
    KeyBinding{"Left", Scope::flight, hold, "aileron", -1.0, "stick left"},
    KeyBinding{"Right", Scope::flight, hold, "aileron", 1.0, "stick right"},
    KeyBinding{"a", Scope::flight, hold, "rudder", 1.0, "left pedal"},
    KeyBinding{"d", Scope::flight, hold, "rudder", -1.0, "right pedal"},
    KeyBinding{"PageUp", Scope::flight, hold, "throttle", 1.0, "more power"},
    KeyBinding{"PageDown", Scope::flight, hold, "throttle", -1.0, "less power"},
    KeyBinding{"w", Scope::flight, hold, "elevator_trim", 1.0, "trim nose down"},
    KeyBinding{"s", Scope::flight, hold, "elevator_trim", -1.0, "trim nose up"},
    KeyBinding{"f", Scope::flight, add, "flaps", 1.0 / 3.0, "flaps down a step"},
    KeyBinding{"g", Scope::flight, add, "flaps", -1.0 / 3.0, "flaps up a step"},
    KeyBinding{"Space", Scope::flight, hold, "brakes", 1.0, "both brakes"},
    KeyBinding{"i", Scope::flight, flip, "ignition", 0.0, "ignition on or off"},
    KeyBinding{"Return", Scope::flight, hold, "starter", 1.0, "starter"},
    KeyBinding{"k", Scope::flight, hold, "mixture", 1.0, "mixture richer"},
    KeyBinding{"j", Scope::flight, hold, "mixture", -1.0, "mixture leaner"},
    KeyBinding{"Comma", Scope::flight, altimeter, "", -1.0, "altimeter setting lower"},
    KeyBinding{"Slash", Scope::flight, altimeter, "", 1.0, "altimeter setting higher"},
    KeyBinding{"Up", Scope::drive, hold, "throttle", 1.0, "throttle, parking brake off"},
    KeyBinding{"Down", Scope::drive, hold, "brake", 1.0, "brake"},
    KeyBinding{"Left", Scope::drive, hold, "steering", 1.0, "steer left"},
    KeyBinding{"Right", Scope::drive, hold, "steering", -1.0, "steer right"},
    KeyBinding{"Space", Scope::drive, hold, "handbrake", 1.0, "handbrake"},
    KeyBinding{"PageUp", Scope::drive, add, "gear", 1.0, "gear: reverse, neutral, drive"},
    KeyBinding{"PageDown", Scope::drive, add, "gear", -1.0, "gear down"},
    KeyBinding{"z", Scope::drive, add, "indicator", 1.0, "indicator: right, off, left"},
    KeyBinding{"x", Scope::drive, add, "indicator", -1.0, "indicator: left, off, right"},
    KeyBinding{"f", Scope::drive, flip, "lights", 0.0, "head lamps on or off"},
};

} // namespace

std::span<const KeyBinding> keyTable()
{
    return kBindings;
}

bool isFor(const KeyBinding& binding, KeyScope vehicle)
{
    switch (binding.scope)
    {
    case KeyScope::all:
        return true;
    case KeyScope::ride:
        return vehicle == KeyScope::flight || vehicle == KeyScope::drive;
    default:
        return binding.scope == vehicle;
    }
}

} // namespace trainer
