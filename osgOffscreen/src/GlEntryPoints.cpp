// SPDX-License-Identifier: Apache-2.0
//
// Dispatch of GL calls in a program with OSMesa, EGL and ordinary windows.
// libosg is linked to libGL, whose functions do not know OSMesa contexts. So the program links libOSMesa
// before libGL (the link options of osgTrainer::osgOffscreen do that): every plain gl* call then goes to
// Mesa's dispatch table, which serves all three. OSG looks up GL functions beyond 1.1 by name, through
// dlsym(glXGetProcAddressARB): the program exports that function itself, here, and answers for the context
// that is current in the calling thread. Source: Mesa 22.3, OSG 3.6.5 (osg/GLExtensions.cpp); tested with
// OSMesa, EGL and an X window in one process.

#include <GL/osmesa.h>
#include <dlfcn.h>
#define EGL_NO_X11
#include <EGL/egl.h>

namespace
{

using GlFunction = void (*)();
using Lookup = GlFunction (*)(const unsigned char*);

template<class Function>
Function nextInLine(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

/// Asks EGL and the window system first: OSMesaGetCurrentContext reads a variable that all of Mesa shares,
/// and returns their contexts, too.
GlFunction functionOfCurrentContext(const unsigned char* name, const char* lookupOfWindows)
{
    const char* text = reinterpret_cast<const char*>(name);
    if (eglGetCurrentContext() != EGL_NO_CONTEXT) return eglGetProcAddress(text);
    const auto currentWindow = nextInLine<void* (*)()>("glXGetCurrentContext");
    const bool inWindow = currentWindow && currentWindow();
    if (!inWindow && OSMesaGetCurrentContext()) return OSMesaGetProcAddress(text);
    const auto lookup = nextInLine<Lookup>(lookupOfWindows);
    return lookup ? lookup(name) : nullptr;
}

} // namespace

extern "C"
{
    [[gnu::visibility("default")]] GlFunction glXGetProcAddressARB(const unsigned char* name)
    {
        return functionOfCurrentContext(name, "glXGetProcAddressARB");
    }

    [[gnu::visibility("default")]] GlFunction glXGetProcAddress(const unsigned char* name)
    {
        return functionOfCurrentContext(name, "glXGetProcAddress");
    }
}
