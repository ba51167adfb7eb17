// SPDX-License-Identifier: Apache-2.0
// A library to preload into a program that draws in a window: each picture takes half a second longer, as on
// a machine that is too slow.
#include <chrono>
#include <thread>

#include <GL/glx.h>
#include <dlfcn.h>

/// Takes the place of libGL's.
extern "C" void glXSwapBuffers(Display* display, GLXDrawable drawable)
{
    using Swap = void (*)(Display*, GLXDrawable);
    static const auto real = reinterpret_cast<Swap>(dlsym(RTLD_NEXT, "glXSwapBuffers"));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    if (real) real(display, drawable);
}
