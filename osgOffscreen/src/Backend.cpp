// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <osgOffscreen/Backend>

namespace osgOffscreen
{

using foundation::Error;
using foundation::Result;

std::string_view backendName(Backend backend)
{
    return backend == Backend::osmesa ? "osmesa" : "egl";
}

Result<Backend> parseBackend(std::string_view word)
{
    for (const Backend backend : {Backend::osmesa, Backend::egl})
    {
        if (word != backendName(backend)) continue;
        if (isAvailable(backend)) return backend;
        return Error{"backend " + std::string(word), "this build has no OSMesa",
                     "use egl, or build with OSGTRAINER_WITH_OSMESA=ON"};
    }
    return Error{"backend '" + std::string(word) + "'", "no such backend", "use osmesa or egl"};
}

bool isAvailable(Backend backend)
{
#ifdef OSGTRAINER_WITH_OSMESA
    return backend == Backend::osmesa || backend == Backend::egl;
#else
    return backend == Backend::egl;
#endif
}

Backend defaultBackend()
{
    return isAvailable(Backend::osmesa) ? Backend::osmesa : Backend::egl;
}

} // namespace osgOffscreen
