// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/order/VertexCacheCost.h>

namespace osgPMObjects::core
{

std::uint64_t fifoTransforms(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                             std::uint32_t cacheSize)
{
    foundation::FifoCache cache(vertexCount, cacheSize);
    for (const Triangle& t : triangles)
        for (const std::uint32_t vertex : t)
            cache.transform(vertex);
    return cache.misses();
}

std::uint64_t batchTransforms(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                              const foundation::BatchLimits& limits)
{
    foundation::BatchCache cache(vertexCount, limits);
    for (const Triangle& t : triangles)
        cache.draw(t);
    return cache.misses();
}

} // namespace osgPMObjects::core
