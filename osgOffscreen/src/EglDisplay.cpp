// SPDX-License-Identifier: Apache-2.0
#include "EglDisplay.h"

#include <cstring>
#include <string>
#include <vector>

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace osgOffscreen
{

namespace
{

template<class Function>
Function eglFunction(const char* name)
{
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// A hardware device's display, or none. Only where GL calls can reach any vendor's driver.
EGLDisplay hardwareDisplay()
{
#ifdef OSGTRAINER_WITH_OSMESA
    return EGL_NO_DISPLAY; // GL entry points are Mesa's own, see GlEntryPoints.cpp
#else
    constexpr EGLint kMostDevices = 64;
    const auto queryDevices = eglFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto queryString = eglFunction<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    std::vector<EGLDeviceEXT> devices(kMostDevices);
    EGLint count = 0;
    if (!queryDevices || !queryString || !queryDevices(kMostDevices, devices.data(), &count))
        return EGL_NO_DISPLAY;
    for (EGLint i = 0; i < count; ++i)
    {
        const char* extensions = queryString(devices[static_cast<std::size_t>(i)], EGL_EXTENSIONS);
        if (extensions && std::strstr(extensions, "EGL_MESA_device_software")) continue;
        const EGLDisplay display =
            eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr);
        if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    }
    return EGL_NO_DISPLAY;
#endif
}

} // namespace

foundation::Result<void*> openEglDisplay()
{
    if (const EGLDisplay display = hardwareDisplay(); display != EGL_NO_DISPLAY) return display;
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    return foundation::Error{"offscreen context (egl)",
                             "no EGL display without a window system (EGL error " +
                                 std::to_string(eglGetError()) + ")",
                             "install libegl-mesa0, or use osmesa"};
}

} // namespace osgOffscreen
