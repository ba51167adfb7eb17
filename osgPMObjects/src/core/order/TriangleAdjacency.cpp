// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>
#include <utility>

#include <osgPMObjects/core/order/TriangleAdjacency.h>

namespace osgPMObjects::core
{

namespace
{

/// One side of an edge: the triangle that it belongs to, and its direction.
struct FaceSide
{
    std::uint32_t high;
    bool isDown; ///< true if it runs from its higher vertex number to the lower
    std::uint32_t triangle;
    std::uint8_t edge;

    bool operator<(const FaceSide& other) const
    {
        return std::tie(high, isDown, triangle, edge) <
               std::tie(other.high, other.isDown, other.triangle, other.edge);
    }
};

/// The sides sorted by their lower vertex: those of vertex v are first[v] to first[v + 1].
struct SidesByVertex
{
    std::vector<std::uint32_t> first;
    std::vector<FaceSide> sides;
};

SidesByVertex sidesByVertex(std::span<const Triangle> triangles)
{
    std::uint32_t vertices = 0;
    for (const Triangle& t : triangles)
        vertices = std::max({vertices, t[0] + 1, t[1] + 1, t[2] + 1});
    SidesByVertex by{std::vector<std::uint32_t>(vertices + 2, 0), {}};
    const auto forEach = [&](auto visit)
    {
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            for (std::uint8_t edge = 0; edge < 3 && !repeatsCorner(triangles[t]); ++edge)
            {
                const std::uint32_t a = triangles[t][edge], b = triangles[t][(edge + 1) % 3];
                visit(std::min(a, b), FaceSide{std::max(a, b), a > b, t, edge});
            }
    };
    forEach([&](std::uint32_t low, const FaceSide&) { ++by.first[low + 2]; });
    for (std::size_t i = 2; i < by.first.size(); ++i)
        by.first[i] += by.first[i - 1];
    by.sides.resize(by.first.back());
    forEach([&](std::uint32_t low, const FaceSide& side) { by.sides[by.first[low + 1]++] = side; });
    return by;
}

} // namespace

TriangleAdjacency::TriangleAdjacency(std::span<const Triangle> triangles)
    : _neighbours(triangles.size(), {kNone, kNone, kNone})
{
    SidesByVertex by = sidesByVertex(triangles);
    for (std::size_t v = 0; v + 1 < by.first.size(); ++v)
    {
        const auto sides = std::span(by.sides).subspan(by.first[v], by.first[v + 1] - by.first[v]);
        std::sort(sides.begin(), sides.end());
        for (std::size_t begin = 0; begin < sides.size();)
        { // all sides of one edge: first those that run up, then those that run down
            std::size_t down = begin;
            while (down < sides.size() && sides[down].high == sides[begin].high && !sides[down].isDown)
                ++down;
            std::size_t end = down;
            while (end < sides.size() && sides[end].high == sides[begin].high)
                ++end;
            for (std::size_t i = begin, j = down; i < down && j < end; ++i, ++j)
                if (sides[i].triangle != sides[j].triangle)
                {
                    _neighbours[sides[i].triangle][sides[i].edge] = sides[j].triangle;
                    _neighbours[sides[j].triangle][sides[j].edge] = sides[i].triangle;
                }
            begin = end;
        }
    }
}

} // namespace osgPMObjects::core
