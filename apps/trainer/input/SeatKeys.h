// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "input/KeyTable.h"

namespace trainer
{

/// Whoever does what keys ask for.
class KeyTarget
{
public:
    virtual ~KeyTarget() = default;

    /// Held keys push an input of the vehicle: up (1), down (-1), or not (0). "brakes" stands for both
    /// brakes.
    virtual void holdInput(std::string_view input, double direction) = 0;
    virtual void addToInput(std::string_view input, double amount) = 0;
    virtual void flipInput(std::string_view input) = 0;

    /// Everything else; actions that are held have the sum of what is held, and 0 when nothing is.
    virtual void act(KeyAction action, double amount) = 0;
};

/// Turns keys that go down and up into actions, by the table. A key that repeats is held, not pressed again.
/// Threads: one.
class SeatKeys
{
public:
    /// `vehicle`: flight or drive; all: there is nothing to control. `target` must outlive it.
    SeatKeys(KeyScope vehicle, KeyTarget& target) : _vehicle(vehicle), _target(target) {}

    void press(int key);
    void release(int key);

    /// Lets go of everything: the window lost the focus.
    void releaseAll();

private:
    const KeyBinding* bindingOf(int key) const;
    void pushHeld(const KeyBinding& binding);

    KeyScope _vehicle;
    KeyTarget& _target;
    std::vector<int> _held;
};

} // namespace trainer
