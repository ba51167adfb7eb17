// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include <osgViewer/GraphicsWindow>

#include "PlayRequest.h"

namespace trainer
{

/// Opens a window that OpenGL draws into; not current in any thread.
/// Errors: no display, no such screen, no OpenGL for windows there, an OpenGL too old.
foundation::Result<osg::ref_ptr<osgViewer::GraphicsWindow>> openWindow(const WindowRequest& request,
                                                                       const FrameRequest& frames);

} // namespace trainer
