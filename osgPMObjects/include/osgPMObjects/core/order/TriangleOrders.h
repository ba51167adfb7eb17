// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// Each function returns an order of a mesh's triangles: a permutation of their numbers. The same mesh gets
/// the same order on every machine. All vertices must be below `vertexCount`.

/// Orders triangles along a Hilbert curve through their centres, so that neighbours in the order are
/// neighbours in space, at any scale. The curve has two dimensions for a flat mesh (a height field), else
/// three. `positions`: by vertex, finite.
/// Cost: n log n. Source: "universal order" in Jin, *Polygon Techniques*; the curve after Skilling,
/// "Programming the Hilbert curve" (2004).
std::vector<std::uint32_t> hilbertOrder(std::span<const Triangle> triangles,
                                        std::span<const glm::dvec3> positions);

/// Orders triangles for caches of any size. It halves the dual graph again and again, with as few edges
/// between the halves as it finds; the half with more neighbours among the triangles drawn before is drawn
/// first.
/// Cost: n log n. Source: Bogomjakov & Gotsman, "Universal rendering sequences for transparent vertex caching
/// of progressive meshes" (2002), as told by Jin, *Polygon Techniques*, "universal order". Differs: a cut is
/// found by breadth-first search from an end of the graph and improved by the moves of Fiduccia & Mattheyses
/// (1982), without a graph library.
std::vector<std::uint32_t> universalOrder(std::span<const Triangle> triangles);

/// Orders triangles in strips side by side. Each strip is so long that a queue of `cacheSize` vertices still
/// holds it when the next strip is laid beside it; this length is found for each strip by trial drawing.
/// `fullSearchEvery`: only so often all lengths are tried, at other strips lengths near the latest; at least
/// 1. 8 takes half the time, and orders cost up to 2 % more.
/// Cost: linear; some 7 · cacheSize² trial triangles a strip, about 2 µs a triangle.
/// Source: Hoppe, "Optimization of mesh locality for transparent vertex caching" (1999), §4 (greedy growth,
/// look-ahead).
/// Differs: the length is chosen once a strip, not at each triangle; every trial draws the same number of
/// triangles, in strips of one length; the first strip of a row goes straight on; the next strip lies beside
/// the latest strip with a free side, or, where the queue has lost that one, begins at a vertex in the queue;
/// triangles that would be left as holes are drawn in passing.
std::vector<std::uint32_t> localityOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                         std::uint32_t cacheSize = 16, std::uint32_t fullSearchEvery = 1);

/// Returns meshoptimizer's order, the best choice for a plain vertex cache of unknown size. Its time grows
/// with the square of the triangles at one vertex: a mesh with more than 10 000 at one vertex gets
/// localityOrder() instead.
std::vector<std::uint32_t> libraryOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount);

/// Returns the triangles in an order.
inline std::vector<Triangle> inOrder(std::span<const Triangle> triangles,
                                     std::span<const std::uint32_t> order)
{
    std::vector<Triangle> ordered;
    ordered.reserve(order.size());
    for (const std::uint32_t t : order)
        ordered.push_back(triangles[t]);
    return ordered;
}

} // namespace osgPMObjects::core
