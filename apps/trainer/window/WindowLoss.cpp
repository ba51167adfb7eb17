// SPDX-License-Identifier: Apache-2.0
#include "window/WindowLoss.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include <X11/Xlib.h>
#include <X11/Xproto.h>

#include <osgViewer/api/X11/GraphicsWindowX11>

#include "terminal/Terminal.h"

namespace trainer
{

namespace
{

/// What the handlers of Xlib, which are functions, know.
struct Watched
{
    std::function<void()> save;
    Window window = None;
    XErrorHandler errorsBefore = nullptr;
    XIOErrorHandler lossesBefore = nullptr;
};

Watched& watched()
{
    static Watched kept;
    return kept;
}

/// Nothing that speaks with the display may run any more, no destructor of a window either.
[[noreturn]] void end(const char* what)
{
    if (const auto save = std::exchange(watched().save, {})) save();
    std::fflush(nullptr);
    const int code = terminal::fail(
        "trainer", foundation::Error{"--window", what, "what was recorded is written; begin again"});
    std::_Exit(code);
}

/// Xlib ends the process when this returns.
int whenDisplayLost(Display* /*display*/)
{
    end("the display has gone away");
}

bool tellsOfLostWindow(const XErrorEvent& error)
{
    const bool isOfKind = error.error_code == BadWindow || error.error_code == BadDrawable ||
                          error.error_code >= FirstExtensionError;
    return isOfKind && watched().window != None && error.resourceid == watched().window;
}

/// The last moment: Mesa's drawing without a GPU asks for the size of the window, takes whatever lies in
/// memory where there is no answer, and faults.
int whenRefused(Display* display, XErrorEvent* error)
{
    if (tellsOfLostWindow(*error)) WindowLoss::endWithoutWindow();
    const XErrorHandler before = watched().errorsBefore;
    return before ? before(display, error) : 0;
}

} // namespace

WindowLoss::WindowLoss(osgViewer::GraphicsWindow& window, std::function<void()> save)
{
    auto* const x11 = dynamic_cast<osgViewer::GraphicsWindowX11*>(&window);
    watched() = {std::move(save), x11 ? x11->getWindow() : None, XSetErrorHandler(whenRefused),
                 XSetIOErrorHandler(whenDisplayLost)};
}

WindowLoss::~WindowLoss()
{
    XSetErrorHandler(watched().errorsBefore);
    XSetIOErrorHandler(watched().lossesBefore);
    watched() = {};
}

void WindowLoss::endWithoutWindow()
{
    end("another program has destroyed the window");
}

} // namespace trainer
