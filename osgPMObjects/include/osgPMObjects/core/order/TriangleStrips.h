// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/order/TriangleAdjacency.h>

namespace osgPMObjects::core
{

/// All triangles, once each, in strips: rows in which each triangle is a neighbour of the one before.
/// Invariant: areStrips().
struct TriangleStrips
{
    std::vector<std::uint32_t> triangles; ///< numbers, strip by strip
    std::vector<std::uint32_t> firsts;    ///< where each strip begins

    std::size_t size() const { return firsts.size(); }
    std::span<const std::uint32_t> strip(std::size_t i) const
    {
        const std::size_t end = i + 1 < firsts.size() ? firsts[i + 1] : triangles.size();
        return std::span(triangles).subspan(firsts[i], end - firsts[i]);
    }
};

bool areStrips(const TriangleStrips& strips, const TriangleAdjacency& adjacency);

/// The vertices of one strip as they are sent. Where it turns to the same side twice, a vertex is repeated; so is the first,
/// where the strip would begin against its orientation. A strip of m triangles that alternates sends m + 2.
/// Source: paper 002, "triangle strips".
std::vector<std::uint32_t> encodeStrip(std::span<const Triangle> triangles,
                                       std::span<const std::uint32_t> strip);

/// The triangles that a card draws for a strip: those without extent are left out.
std::vector<Triangle> decodeStrip(std::span<const std::uint32_t> sent);

/// Improved SGI: begins at a triangle with the fewest neighbours left, of equal ones at that whose neighbours have the fewest
/// left, extends the three strips through it both ways, keeps the longest, and goes on so. Strips alternate.
/// Cost: n log n. Source: paper 002, "improved SGI"; Akeley, Haeberli & Burns, tomesh (1990).
TriangleStrips sgiStrips(std::span<const Triangle> triangles);

/// Paths in a spanning tree of the dual graph, as few as that tree allows. Strips turn as they like.
/// Cost: linear, after the adjacency. Source: paper 002, "dual graph"; after Xiang, Held & Mitchell, "Fast and effective
/// stripification of polygonal surface models" (1999). Differs: the tree is searched depth first, towards neighbours with the
/// fewest neighbours left, and cut into the least number of paths, from its leaves up.
TriangleStrips dualGraphStrips(std::span<const Triangle> triangles);

/// The same strips in another order, some of them backwards: next is always the one whose beginning costs a simulated queue of
/// `cacheSize` vertices the least, among those that have a vertex in it.
/// Cost: for each strip, the beginnings of up to 64 others. Source: paper 002, "cache-friendly stripping".
TriangleStrips cacheOrderedStrips(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                  const TriangleStrips& strips, std::uint32_t cacheSize);

} // namespace osgPMObjects::core
