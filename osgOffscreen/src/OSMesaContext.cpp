// SPDX-License-Identifier: Apache-2.0
#include <GL/osmesa.h>

#include <osgOffscreen/OSMesaContext>

namespace osgOffscreen
{

namespace
{

constexpr int kStubEdgePx = 16;

::OSMesaContext native(void* context)
{
    return static_cast<::OSMesaContext>(context);
}

} // namespace

OSMesaContext::OSMesaContext(const OffscreenSettings& settings)
    : OffscreenContext(settings), _stub(static_cast<std::size_t>(kStubEdgePx) * kStubEdgePx * 4)
{
    const int attributes[] = {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    _context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (_context)
        setNative(foundation::success());
    else
        setNative(foundation::Error{"offscreen context (osmesa)",
                                    "OSMesa gives no compatibility-profile context",
                                    "install libosmesa6, or use egl"});
}

OSMesaContext::~OSMesaContext()
{
    close(true);
}

bool OSMesaContext::makeNativeCurrent()
{
    return OSMesaMakeCurrent(native(_context), _stub.data(), GL_UNSIGNED_BYTE, kStubEdgePx, kStubEdgePx);
}

bool OSMesaContext::releaseNative()
{
    return OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
}

void OSMesaContext::destroyNative()
{
    OSMesaDestroyContext(native(_context));
    _context = nullptr;
}

} // namespace osgOffscreen
