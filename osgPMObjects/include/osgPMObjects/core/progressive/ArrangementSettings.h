// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <foundation/Result.h>

namespace osgPMObjects::core
{

/// How one index buffer keeps the faces of every level in an order that suits the vertex cache.
enum class Arrangement
{
    plain,   ///< vanishing faces are always the last: nothing moves, the vertex cache is used badly
    tswap,   ///< vanished faces wait as holes, until cycles of faces close all of them (Graphicon 2003)
    blocks,  ///< the last face of a small block fills each hole; neighbours merge when they are half empty
    windows, ///< neighbouring blocks are reordered together as soon as they fit into one block less
};

/// The parameters of an arrangement. Invariant: checkSettings().
/// Source: for *tswap*, *Cache-friendly view-independent progressive meshes* (Graphicon 2003), section 5.
struct ArrangementSettings
{
    static constexpr std::uint32_t kMostCacheSize = 1024;
    static constexpr std::uint32_t kMostBlockFaces = 1u << 20;
    static constexpr std::uint32_t kMostWindowBlocks = 64;
    static constexpr std::uint32_t kMostLookAhead = 16;

    Arrangement arrangement = Arrangement::windows;
    /// Number of vertices that the target's vertex cache (a queue) holds; 3 … kMostCacheSize.
    std::uint32_t cacheSize = 16;
    /// *blocks*, *windows*: faces of a block, at most kMostBlockFaces; 0: 32 for blocks, 1024 to 3072 for
    /// windows, by the faces of the material.
    std::uint32_t blockFaces = 0;
    /// *windows*: number of neighbouring blocks that become one less; 2 … kMostWindowBlocks. More blocks keep
    /// a better order for more moves: 2 moves a step with 2, 4 with 3.
    std::uint32_t windowBlocks = 3;
    /// *tswap*: share of the faces that vanish before cycles close their holes (the "atomic step"); above 0,
    /// at most 1. A smaller share draws fewer holes for more moves: .1: 5 % and 17 a step, .2: 9 % and 8, .3:
    /// 21 % and 4.6.
    float tswapStep = 0.2f;
    /// *tswap*: worth of a face that keeps its slot, and of a processor's cache line that is written anyway.
    /// Unit: transformed vertices; finite, at least 0.
    float stayWeight = 1.0f, touchedLineWeight = 0.25f;
    /// *tswap*: number of faces that are tried before the next one is chosen; 1 (no look-ahead) …
    /// kMostLookAhead.
    std::uint32_t lookAhead = 1;
};

/// Tells whether faces can be arranged by these settings: else an error that names the field and its range.
/// buildProgressiveMesh() does not check.
foundation::Outcome checkSettings(const ArrangementSettings& settings);

} // namespace osgPMObjects::core
