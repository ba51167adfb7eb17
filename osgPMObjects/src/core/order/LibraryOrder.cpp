// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>

#include <meshoptimizer.h>

#include <osgPMObjects/core/order/TriangleOrders.h>

namespace osgPMObjects::core
{

namespace
{

/// The limit of triangles at a vertex: at each step the library tests all triangles left at each vertex of
/// its cache.
constexpr std::uint32_t kMostAtAVertex = 10'000;

/// Returns for each triangle of `made` its number in `given`, which has the same triangles, corner by corner.
/// Equal triangles keep their order. Cost: linear in the triangles times those with one first corner.
std::vector<std::uint32_t> numbersOfTriangles(std::span<const Triangle> given, std::span<const Triangle> made,
                                              std::uint32_t vertexCount)
{
    std::vector<std::uint32_t> next(std::size_t{vertexCount} + 1,
                                    0); // by first corner: its first entry in byCorner
    for (const Triangle& t : given)
        ++next[t[0] + 1];
    for (std::size_t v = 1; v < next.size(); ++v)
        next[v] += next[v - 1];
    std::vector<std::uint32_t> byCorner(given.size()), ends(next.begin(), next.end());
    for (std::uint32_t i = 0; i < given.size(); ++i)
        byCorner[ends[given[i][0]]++] = i;
    std::vector<std::uint32_t> numbers;
    numbers.reserve(made.size());
    for (const Triangle& t : made)
    {
        std::uint32_t& first = next[t[0]];
        const auto begin = byCorner.begin() + first, end = byCorner.begin() + ends[t[0]];
        const auto found = std::find_if(begin, end, [&](std::uint32_t i) { return given[i] == t; });
        numbers.push_back(*found);
        std::rotate(begin, found, found + 1); // the others stay in order
        ++first;
    }
    return numbers;
}

std::uint32_t mostAtAVertex(std::span<const Triangle> triangles, std::uint32_t vertexCount)
{
    std::vector<std::uint32_t> count(vertexCount, 0);
    for (const Triangle& t : triangles)
        for (const std::uint32_t vertex : t)
            ++count[vertex];
    return *std::max_element(count.begin(), count.end());
}

} // namespace

std::vector<std::uint32_t> libraryOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount)
{
    if (triangles.empty()) return {};
    if (mostAtAVertex(triangles, vertexCount) > kMostAtAVertex) return localityOrder(triangles, vertexCount);
    std::vector<Triangle> ordered(triangles.size());
    meshopt_optimizeVertexCache(ordered.front().data(), triangles.front().data(), 3 * triangles.size(),
                                vertexCount);
    // The library returns indices and keeps the order of corners.
    return numbersOfTriangles(triangles, ordered, vertexCount);
}

} // namespace osgPMObjects::core
