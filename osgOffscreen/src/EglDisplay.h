// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

namespace osgOffscreen
{

/// An initialised EGLDisplay that needs no window system; see EglContext for which.
/// Errors: EGL too old, or no platform that works; names the EGL error.
foundation::Result<void*> openEglDisplay();

} // namespace osgOffscreen
