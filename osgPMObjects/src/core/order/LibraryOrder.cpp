// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <tuple>

#include <meshoptimizer.h>

#include <osgPMObjects/core/order/TriangleOrders.h>

namespace osgPMObjects::core
{

namespace
{

/// The limit of triangles at a vertex: at each step the library tests all triangles left at each vertex of its cache.
constexpr std::uint32_t kMostAtAVertex = 10'000;

/// Returns the numbers of triangles, sorted by their corners.
std::vector<std::uint32_t> byCorners(std::span<const Triangle> triangles)
{
    std::vector<std::uint32_t> numbers(triangles.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    std::sort(numbers.begin(), numbers.end(),
              [&](std::uint32_t a, std::uint32_t b)
              { return std::tie(triangles[a], a) < std::tie(triangles[b], b); });
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
    // The library returns indices and keeps the order of corners, so equal triangles match after sorting.
    const std::vector<std::uint32_t> given = byCorners(triangles), made = byCorners(ordered);
    std::vector<std::uint32_t> order(triangles.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[made[i]] = given[i];
    return order;
}

} // namespace osgPMObjects::core
