// SPDX-License-Identifier: Apache-2.0
// A library to preload into a program that draws in a window: by a connection of its own to the display it
// destroys that window, as another program could, at the moment that OSGTRAINER_LOSE_WINDOW names: "draw N",
// before the N-th picture is begun, "show N" or "shown N", before or after it is shown.
#include <cstdlib>
#include <sstream>
#include <string>

#include <GL/glx.h>
#include <dlfcn.h>

namespace
{

void destroy(GLXDrawable window)
{
    Display* const other = XOpenDisplay(nullptr);
    if (!other) return;
    XDestroyWindow(other, window);
    XCloseDisplay(other);
}

/// Counts pictures, and destroys the window where the moment has come.
void passMoment(const std::string& name, GLXDrawable window)
{
    static int pictures = 0;
    std::istringstream words(std::getenv("OSGTRAINER_LOSE_WINDOW"));
    std::string wanted;
    int number = 0;
    words >> wanted >> number;
    if (name == wanted && pictures == number) destroy(window);
    if (name == "shown") ++pictures;
}

} // namespace

/// Takes the place of libGL's.
extern "C" Bool glXMakeCurrent(Display* display, GLXDrawable drawable, GLXContext context)
{
    using Make = Bool (*)(Display*, GLXDrawable, GLXContext);
    static const auto real = reinterpret_cast<Make>(dlsym(RTLD_NEXT, "glXMakeCurrent"));
    if (drawable != None) passMoment("draw", drawable);
    return real(display, drawable, context);
}

/// Takes the place of libGL's.
extern "C" void glXSwapBuffers(Display* display, GLXDrawable drawable)
{
    using Swap = void (*)(Display*, GLXDrawable);
    static const auto real = reinterpret_cast<Swap>(dlsym(RTLD_NEXT, "glXSwapBuffers"));
    passMoment("show", drawable);
    real(display, drawable);
    passMoment("shown", drawable);
}
