// SPDX-License-Identifier: Apache-2.0
#include "EdgesWithoutTwin.h"

#include <algorithm>
#include <bit>
#include <cstddef>

#include <foundation/Random.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Visits the edges of all triangles, between the vertices that theirs count as.
template<class Visit>
void forEachEdge(std::span<const LeafTriangle> triangles, std::span<const std::uint32_t> same,
                 const Visit& visit)
{
    for (const LeafTriangle& t : triangles)
        for (int i = 0; i < 3; ++i)
            visit(same[t.vertices[i]], same[t.vertices[(i + 1) % 3]],
                  SlotEdge{t.vertices[i], t.vertices[(i + 1) % 3]});
}

std::size_t hashOf(GridPoint p)
{
    const std::uint64_t key =
        std::uint64_t{static_cast<std::uint32_t>(p.row)} << 32 | static_cast<std::uint32_t>(p.column);
    const std::uint64_t mixed = (key ^ key >> 29) * foundation::SplitMix64::kStep;
    return mixed >> 20;
}

} // namespace

std::vector<std::uint32_t> firstAtPlace(std::span<const GridPoint> points)
{
    std::vector<std::uint32_t> table(std::bit_ceil(2 * points.size() + 1), kNone), first(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
    {
        std::size_t at = hashOf(points[i]) & (table.size() - 1);
        while (table[at] != kNone && points[table[at]] != points[i])
            at = (at + 1) & (table.size() - 1);
        if (table[at] == kNone) table[at] = i;
        first[i] = table[at];
    }
    return first;
}

std::vector<SlotEdge> edgesWithoutTwin(std::span<const LeafTriangle> triangles,
                                       std::span<const std::uint32_t> same)
{
    // The ends of the edges that begin at a vertex lie side by side.
    std::vector<std::uint32_t> begins(same.size() + 1, 0), ends(3 * triangles.size());
    forEachEdge(triangles, same, [&](std::uint32_t from, std::uint32_t, SlotEdge) { ++begins[from]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& begin : begins)
        begin = sum += begin;
    forEachEdge(triangles, same,
                [&](std::uint32_t from, std::uint32_t to, SlotEdge) { ends[--begins[from]] = to; });

    std::vector<SlotEdge> open;
    forEachEdge(triangles, same,
                [&](std::uint32_t from, std::uint32_t to, SlotEdge edge)
                {
                    const auto last = ends.begin() + begins[to + 1];
                    if (std::find(ends.begin() + begins[to], last, from) == last) open.push_back(edge);
                });
    return open;
}

} // namespace osgTerrainROAM::core
