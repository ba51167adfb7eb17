// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// What the paper's greedy order weighs, in transformed vertices.
struct GreedyWeights
{
    float stays = 0.0f;       ///< a face that has this place already
    float lineTouched = 0.0f; ///< a face in a line of the processor's cache that is written anyway
};

/// An order of triangles, as their numbers, that begins with the first and goes on with whichever uses the cache best, or stays where
/// it is. When no triangle uses the cache, the first that is left.
/// `isTouched`: by place, whether it is written anyway; empty: none is.
/// Source: paper 003, §5 (the greedy algorithm, without look-ahead). Differs: a line is touched as soon as a face in it has moved, too.
std::vector<std::uint32_t> greedyOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                       std::uint32_t cacheSize, const GreedyWeights& weights = {},
                                       std::vector<bool> isTouched = {});

} // namespace osgPMObjects::core
