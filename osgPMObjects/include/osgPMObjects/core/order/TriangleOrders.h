// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// Orders of the triangles of a mesh, as their numbers: each comes once. The same mesh has the same order on every machine.
/// Vertices are below `vertexCount`.

/// Along a Hilbert curve through the centres of the triangles: neighbours in the order are neighbours in space, at any scale.
/// The curve has as many dimensions as the mesh is not flat in: two for a height field. `positions`: by vertex, finite.
/// Cost: n log n. Source: paper 002, "universal order"; the curve after Skilling, "Programming the Hilbert curve" (2004).
std::vector<std::uint32_t> hilbertOrder(std::span<const Triangle> triangles,
                                        std::span<const glm::dvec3> positions);

/// Good for caches of any size: halves the dual graph with as few edges between the halves as it can, again and again, and
/// draws the half first that has more to do with what was drawn before.
/// Cost: n log n. Source: Bogomjakov & Gotsman, "Universal rendering sequences for transparent vertex caching of progressive
/// meshes" (2002), as in paper 002, "universal order". Differs: a cut is found by breadth-first search from an end of the
/// graph, and mended by Fiduccia and Mattheyses's moves (1982), instead of by a library for graphs.
std::vector<std::uint32_t> universalOrder(std::span<const Triangle> triangles);

/// Strips side by side, each as long as a queue of `cacheSize` vertices still holds it when the next is laid along it: how
/// long that is, is tried out for each strip by drawing what would follow.
/// Cost: linear; for each strip some 7 · cacheSize² triangles are tried: a few µs a triangle.
/// Source: Hoppe, "Optimization of mesh locality for transparent vertex caching" (1999), §4 (greedy growth, look-ahead).
/// Differs: the length is chosen once for a strip, not anew at each of its triangles; every trial goes over the same number
/// of triangles, in strips of one length; the first strip of a row goes straight on; the next strip lies along the latest one
/// that has a side left, and where the queue has lost that, it goes on at a vertex in the queue; triangles that would be left
/// as holes are drawn in passing.
std::vector<std::uint32_t> localityOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                         std::uint32_t cacheSize = 16);

/// meshoptimizer's order, the choice where nothing else counts than a cache: its own scores, made for all sizes alike. Its
/// time grows with the square of the triangles at one vertex: where there are more than 10 000, localityOrder() instead.
std::vector<std::uint32_t> libraryOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount);

/// The triangles in an order.
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
