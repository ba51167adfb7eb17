// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <foundation/VertexCache.h>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// Returns how many vertices a queue of `cacheSize` vertices transforms when it draws the triangles in their
/// order. The best is each vertex once (half a vertex a triangle on large closed meshes), the worst three a
/// triangle.
std::uint64_t fifoTransforms(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                             std::uint32_t cacheSize);

/// Returns how many vertices a card transforms that works on batches of triangles (foundation::BatchCache).
std::uint64_t batchTransforms(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                              const foundation::BatchLimits& limits = foundation::BatchCache::kNvidia);

} // namespace osgPMObjects::core
