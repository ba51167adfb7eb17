// SPDX-License-Identifier: Apache-2.0
// A library to preload into a program that reads devices by SDL: it makes up a stick that comes, moves, is
// pulled and returns, as somebody pulls a plug. Each reading of the devices counts; times are seconds since
// the first.
#include <chrono>
#include <cstdint>

#include <SDL.h>
#include <dlfcn.h>

namespace
{

struct Stick
{
    int device = -1;
    SDL_Joystick* opened = nullptr;

    void come()
    {
        device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_FLIGHT_STICK, 2, 2, 0);
        opened = device < 0 ? nullptr : SDL_JoystickOpen(device);
    }

    void go()
    {
        if (opened) SDL_JoystickClose(opened);
        if (device >= 0) SDL_JoystickDetachVirtual(device);
        opened = nullptr;
        device = -1;
    }

    void move(Sint16 axis, bool isPressed) const
    {
        if (!opened) return;
        SDL_JoystickSetVirtualAxis(opened, 0, axis);
        SDL_JoystickSetVirtualButton(opened, 0, isPressed ? 1 : 0);
    }
};

} // namespace

/// Takes the place of SDL's.
extern "C" void SDL_JoystickUpdate()
{
    static const auto begun = std::chrono::steady_clock::now();
    static Stick stick;
    static int stage = 0;
    const double timeS = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    constexpr double kAtS[] = {0.5, 1.0, 2.0, 3.0, 3.5};
    if (stage < 5 && timeS > kAtS[stage])
    {
        if (stage == 0 || stage == 3) stick.come();
        if (stage == 1) stick.move(20'000, true);
        if (stage == 2) stick.go();
        if (stage == 4) stick.move(-20'000, false);
        ++stage;
    }
    using Update = void (*)();
    static const auto real = reinterpret_cast<Update>(dlsym(RTLD_NEXT, "SDL_JoystickUpdate"));
    if (real) real();
}
