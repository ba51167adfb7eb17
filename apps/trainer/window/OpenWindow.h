// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include <osgViewer/GraphicsWindow>

#include "request/PlayRequest.h"

namespace trainer
{

/// A window, and whether its driver draws on the processor, without a GPU.
struct OpenedWindow
{
    osg::ref_ptr<osgViewer::GraphicsWindow> window;
    bool drawsOnProcessor = false;
};

/// Tells whether there is the display, and the screen of it, that a window would be on. Errors: there is
/// none.
foundation::Outcome checkDisplay(const WindowRequest& request);

/// Opens a window that OpenGL draws into; not current in any thread.
/// Errors: no display, no such screen, no OpenGL for windows there, an OpenGL too old.
foundation::Result<OpenedWindow> openWindow(const WindowRequest& request, const FrameRequest& frames);

} // namespace trainer
