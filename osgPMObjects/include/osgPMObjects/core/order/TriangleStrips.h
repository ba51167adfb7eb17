// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/order/TriangleAdjacency.h>

namespace osgPMObjects::core
{

/// A partition of a mesh's triangles into strips: sequences in which each triangle is a neighbour of the one
/// before.
/// Invariant: areStrips().
struct TriangleStrips
{
    std::vector<std::uint32_t> triangles; ///< numbers, strip by strip
    std::vector<std::uint32_t> firsts;    ///< by strip: index of its first triangle

    std::size_t size() const { return firsts.size(); }
    std::span<const std::uint32_t> strip(std::size_t i) const
    {
        const std::size_t end = i + 1 < firsts.size() ? firsts[i + 1] : triangles.size();
        return std::span(triangles).subspan(firsts[i], end - firsts[i]);
    }
};

bool areStrips(const TriangleStrips& strips, const TriangleAdjacency& adjacency);

/// Returns the vertices of one strip as they are sent to the card. Two turns to the same side repeat a
/// vertex; so does a strip that begins against its orientation. A strip of m triangles whose turns alternate
/// has m + 2 vertices.
/// Source: Jin, *Polygon Techniques*, "triangle strips".
std::vector<std::uint32_t> encodeStrip(std::span<const Triangle> triangles,
                                       std::span<const std::uint32_t> strip);

/// Returns the triangles that a card draws for a strip, without those of area zero.
std::vector<Triangle> decodeStrip(std::span<const std::uint32_t> sent);

/// Returns the vertices of all strips as one strip: between two of them some are repeated, which makes
/// triangles of area zero. decodeStrip() has all triangles again, with their orientation.
std::vector<std::uint32_t> joinStrips(std::span<const Triangle> triangles, const TriangleStrips& strips);

/// Makes strips by the improved SGI algorithm. It begins at the triangle with the fewest free neighbours (a
/// tie goes to the one whose neighbours have the fewest), grows the three strips through it in both
/// directions, keeps the longest, and repeats. Turns alternate.
/// Cost: n log n. Source: Jin, *Polygon Techniques*, "improved SGI"; Akeley, Haeberli & Burns, tomesh (1990).
TriangleStrips sgiStrips(std::span<const Triangle> triangles);

/// Makes strips that are paths in a spanning tree of the dual graph, as few as that tree allows; turns need
/// not alternate.
/// Cost: linear, after the adjacency. Source: Jin, *Polygon Techniques*, "dual graph", after Xiang, Held &
/// Mitchell, "Fast and effective stripification of polygonal surface models" (1999). Differs: the tree comes
/// from a depth-first search that prefers neighbours with the fewest free neighbours, and is cut into the
/// least number of paths from its leaves up.
TriangleStrips dualGraphStrips(std::span<const Triangle> triangles);

/// Reorders strips, and reverses some of them. The next strip is the one whose first triangles cost a
/// simulated queue of `cacheSize` vertices the least, among the strips that have a vertex in it.
/// Cost: for each strip, the first triangles of up to 64 others. Source: Jin, *Polygon Techniques*,
/// "cache-friendly stripping".
TriangleStrips cacheOrderedStrips(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                  const TriangleStrips& strips, std::uint32_t cacheSize);

/// How strips are made.
enum class StripKind
{
    sgi,       ///< sgiStrips()
    dualGraph, ///< dualGraphStrips()
};

/// The strips of a kind, in an order that suits a queue of 16 vertices.
TriangleStrips stripsOf(std::span<const Triangle> triangles, std::uint32_t vertexCount, StripKind kind);

} // namespace osgPMObjects::core
