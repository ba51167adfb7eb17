// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <foundation/VertexCache.h>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// How many vertices are transformed when the triangles are drawn in their order, by a queue of the last `cacheSize`. At
/// best each vertex once: half a vertex a triangle on large closed meshes; at worst three.
std::uint64_t fifoTransforms(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                             std::uint32_t cacheSize);

/// The same by batches.
std::uint64_t batchTransforms(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                              const foundation::BatchLimits& limits = foundation::BatchCache::kNvidia);

} // namespace osgPMObjects::core
