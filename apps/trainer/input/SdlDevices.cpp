// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <SDL.h>

#include "input/Devices.h"

namespace trainer
{

namespace
{

constexpr double kFullAxis = 32767.0;

} // namespace

/// SDL gets no window, so it must look at devices without a focus; signals are the program's own.
Devices::Devices()
{
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (SDL_InitSubSystem(SDL_INIT_JOYSTICK) != 0) _fault = SDL_GetError();
}

Devices::~Devices()
{
    _opened.clear();
    if (_fault.empty()) SDL_QuitSubSystem(SDL_INIT_JOYSTICK);
}

std::vector<std::string> Devices::update()
{
    std::vector<std::string> notes;
    if (!_fault.empty()) return notes;
    SDL_JoystickUpdate();
    for (SDL_Event event; SDL_PeepEvents(&event, 1, SDL_GETEVENT, SDL_FIRSTEVENT, SDL_LASTEVENT) == 1;)
    {
        if (event.type != SDL_JOYDEVICEADDED) continue;
        SDL_Joystick* const joystick = SDL_JoystickOpen(event.jdevice.which);
        if (!joystick) continue;
        const char* const name = SDL_JoystickName(joystick);
        _opened.emplace_back(joystick,
                             [](void* opened) { SDL_JoystickClose(static_cast<SDL_Joystick*>(opened)); });
        _states.push_back({name ? name : "device without a name", {}, {}});
        notes.push_back(_states.back().name + " is there");
    }
    for (std::size_t i = _opened.size(); i-- > 0;)
    {
        auto* const joystick = static_cast<SDL_Joystick*>(_opened[i].get());
        DeviceState& state = _states[i];
        if (SDL_JoystickGetAttached(joystick) == SDL_FALSE)
        {
            notes.push_back(state.name + " is gone");
            _states.erase(_states.begin() + static_cast<std::ptrdiff_t>(i));
            _opened.erase(_opened.begin() + static_cast<std::ptrdiff_t>(i));
            continue;
        }
        state.axes.resize(static_cast<std::size_t>(std::max(SDL_JoystickNumAxes(joystick), 0)));
        for (std::size_t axis = 0; axis < state.axes.size(); ++axis)
            state.axes[axis] =
                std::max(-1.0, SDL_JoystickGetAxis(joystick, static_cast<int>(axis)) / kFullAxis);
        state.isPressed.resize(static_cast<std::size_t>(std::max(SDL_JoystickNumButtons(joystick), 0)));
        for (std::size_t button = 0; button < state.isPressed.size(); ++button)
            state.isPressed[button] = SDL_JoystickGetButton(joystick, static_cast<int>(button)) != 0;
    }
    return notes;
}

} // namespace trainer
