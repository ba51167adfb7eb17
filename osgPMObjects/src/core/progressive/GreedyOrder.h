// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// The bonuses of the greedy order, in transformed vertices.
struct GreedyWeights
{
    float stays = 0.0f;       ///< for a face that keeps its position
    float lineTouched = 0.0f; ///< for a face in a cache line of the processor that is written anyway
};

/// Returns an order of triangles, as their numbers. It begins with the first triangle. The next one is always the triangle
/// that costs the vertex cache least, minus its bonus; if no triangle uses the cache, the first one left.
/// `isTouched`: by position, whether it is written anyway; empty: none is.
/// Source: *Cache-friendly view-independent progressive meshes* (Graphicon 2003), section 5 (greedy algorithm, without
/// look-ahead). Differs: a line also counts as touched once a face in it has moved.
std::vector<std::uint32_t> greedyOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                       std::uint32_t cacheSize, const GreedyWeights& weights = {},
                                       std::vector<bool> isTouched = {});

} // namespace osgPMObjects::core
