// SPDX-License-Identifier: Apache-2.0
#include <string>

#define EGL_NO_X11
#include <EGL/egl.h>

#include <osgOffscreen/EglContext>

#include "EglDisplay.h"

namespace osgOffscreen
{

EglContext::EglContext(const OffscreenSettings& settings) : OffscreenContext(settings)
{
    setNative(createNative());
}

EglContext::~EglContext()
{
    close(true);
}

foundation::Outcome EglContext::createNative()
{
    const auto failure = [](const std::string& step)
    {
        return foundation::Error{"offscreen context (egl)",
                                 step + " failed (EGL error " + std::to_string(eglGetError()) + ")",
                                 "install libegl-mesa0 and libgl1-mesa-dri, or use osmesa"};
    };
    foundation::Result<void*> display = openEglDisplay();
    if (!display) return display.error();
    _display = *display;

    const EGLint wanted[] = {EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(_display, wanted, &config, 1, &count) || count < 1)
        return failure("eglChooseConfig");
    const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    _surface = eglCreatePbufferSurface(_display, config, size);
    if (_surface == EGL_NO_SURFACE) return failure("eglCreatePbufferSurface");
    // No version asked for: the newest compatibility profile.
    if (eglBindAPI(EGL_OPENGL_API)) _context = eglCreateContext(_display, config, EGL_NO_CONTEXT, nullptr);
    if (_context == EGL_NO_CONTEXT)
    {
        foundation::Error error = failure("eglCreateContext");
        eglDestroySurface(_display, _surface);
        return error;
    }
    return foundation::success();
}

bool EglContext::makeNativeCurrent()
{
    // The API is bound per thread, and osgViewer draws in threads of its own.
    return eglBindAPI(EGL_OPENGL_API) && eglMakeCurrent(_display, _surface, _surface, _context);
}

bool EglContext::releaseNative()
{
    return eglBindAPI(EGL_OPENGL_API) &&
           eglMakeCurrent(_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

void EglContext::destroyNative()
{
    eglDestroyContext(_display, _context);
    eglDestroySurface(_display, _surface);
    _context = nullptr;
    _surface = nullptr;
}

} // namespace osgOffscreen
