// SPDX-License-Identifier: Apache-2.0
#include "window/WindowWatch.h"

#include <X11/Xlib.h>

#include <osgViewer/api/X11/GraphicsWindowX11>

namespace trainer
{

struct WindowWatch::Connection
{
    explicit Connection(Display* opened) : display(opened) {}
    ~Connection() { XCloseDisplay(display); }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    Display* display;
};

WindowWatch::WindowWatch(osgViewer::GraphicsWindow& window)
{
    auto* const x11 = dynamic_cast<osgViewer::GraphicsWindowX11*>(&window);
    Display* const display = x11 ? XOpenDisplay(window.getTraits()->displayName().c_str()) : nullptr;
    if (!display) return;
    _connection = std::make_unique<Connection>(display);
    XSelectInput(display, x11->getWindow(), FocusChangeMask | StructureNotifyMask);
    XSync(display, False);
}

WindowWatch::~WindowWatch() = default;

WindowWatch::State WindowWatch::look()
{
    _state.hasLostFocus = false;
    if (!_connection) return _state;
    Display* const display = _connection->display;
    while (XPending(display) > 0)
    {
        XEvent event;
        XNextEvent(display, &event);
        switch (event.type)
        {
        case FocusOut:
            // A window manager that grabs the keyboard for a moment takes the focus, too: keys may come up
            // unseen.
            _state.hasLostFocus |= event.xfocus.detail != NotifyInferior;
            break;
        case UnmapNotify:
            _state.isHidden = _state.hasLostFocus = true;
            break;
        case MapNotify:
            _state.isHidden = false;
            break;
        case DestroyNotify:
            _state.isGone = true;
            break;
        default:
            break;
        }
    }
    return _state;
}

} // namespace trainer
