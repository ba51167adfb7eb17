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

/// The rules of the greedy order.
struct GreedyRules
{
    std::uint32_t cacheSize = 16;
    GreedyWeights weights{};
    std::uint32_t lookAhead = 1; ///< number of triangles that are tried before one is chosen
};

/// Where triangles lie in a buffer before they are ordered.
struct GreedyPlaces
{
    std::vector<std::uint32_t> positionOf; ///< by triangle, ascending; empty: their numbers
    std::vector<bool> isTouched;           ///< by position: whether it is written anyway; empty: none is
};

/// Returns an order of triangles, as their numbers: the n-th gets position n. It begins with the first
/// triangle. The next one is always the triangle that costs the vertex cache least, minus its bonus; if no
/// triangle uses the cache, the first one left. With look-ahead each candidate is tried together with the
/// triangles that the order without look-ahead would draw after it, and the least sum wins.
/// Cost: linear; look-ahead over n triangles takes some 30 n times as long.
/// Source: *Cache-friendly view-independent progressive meshes* (Graphicon 2003), section 5 (greedy
/// algorithm; look-ahead is mentioned and left). Differs: a line also counts as touched once a face in it has
/// moved.
std::vector<std::uint32_t> greedyOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                       const GreedyRules& rules, GreedyPlaces places = {});

} // namespace osgPMObjects::core
