// SPDX-License-Identifier: Apache-2.0
#include "input/SeatKeys.h"

#include <algorithm>

#include "input/Keys.h"

namespace trainer
{

const KeyBinding* SeatKeys::bindingOf(int key) const
{
    for (const KeyBinding& binding : keyTable())
        if (keyOf(binding.key) == key && isFor(binding, _vehicle)) return &binding;
    return nullptr;
}

/// Two keys against each other push nowhere.
void SeatKeys::pushHeld(const KeyBinding& binding)
{
    double sum = 0.0;
    for (const int key : _held)
        if (const KeyBinding* held = bindingOf(key))
            if (held->action == binding.action && held->input == binding.input) sum += held->amount;
    if (binding.action != KeyAction::hold) return _target.act(binding.action, sum);
    _target.holdInput(binding.input, std::clamp(sum, -1.0, 1.0));
}

void SeatKeys::press(int key)
{
    if (std::find(_held.begin(), _held.end(), key) != _held.end()) return;
    _held.push_back(key);
    const KeyBinding* binding = bindingOf(key);
    if (!binding) return;
    if (isHeld(binding->action)) return pushHeld(*binding);
    switch (binding->action)
    {
    case KeyAction::add:
        return _target.addToInput(binding->input, binding->amount);
    case KeyAction::flip:
        return _target.flipInput(binding->input);
    default:
        return _target.act(binding->action, binding->amount);
    }
}

void SeatKeys::release(int key)
{
    const auto found = std::find(_held.begin(), _held.end(), key);
    if (found == _held.end()) return;
    _held.erase(found);
    const KeyBinding* binding = bindingOf(key);
    if (binding && isHeld(binding->action)) pushHeld(*binding);
}

void SeatKeys::releaseAll()
{
    while (!_held.empty())
        release(_held.back());
}

} // namespace trainer
