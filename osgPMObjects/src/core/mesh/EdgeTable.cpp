// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/mesh/EdgeTable.h>

namespace osgPMObjects::core
{

namespace
{

/// The least number of positions for a thread.
constexpr std::size_t kLeastPositionsAThread = 16384;

/// Returns the ends of a side, the lower first.
std::pair<std::uint32_t, std::uint32_t> sortedEnds(std::span<const Triangle> triangles, HalfEdge side)
{
    const auto [from, to] = endsOf(triangles, side);
    return std::minmax(from, to);
}

} // namespace

std::vector<Triangle> positionTriangles(const Mesh& mesh)
{
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.faces.size());
    for (const Face& face : mesh.faces)
        triangles.push_back({mesh.positionOf(face, 0), mesh.positionOf(face, 1), mesh.positionOf(face, 2)});
    return triangles;
}

EdgeTable::EdgeTable(std::span<const Triangle> triangles, std::size_t positionCount)
    : _edgeOfSide(3 * triangles.size(), kNone)
{
    // Counting sort by the lower end, then each bucket by the higher one.
    struct Entry
    {
        std::uint32_t high;
        HalfEdge side;
        bool operator<(const Entry& o) const { return high != o.high ? high < o.high : side < o.side; }
    };
    std::vector<std::uint32_t> bucket(positionCount + 1, 0);
    const auto sideCount = static_cast<HalfEdge>(3 * triangles.size());
    const auto forEachSide = [&](const auto& visit)
    {
        for (HalfEdge side = 0; side < sideCount; ++side)
            if (const auto [low, high] = sortedEnds(triangles, side); low != high) visit(side, low, high);
    };
    forEachSide([&](HalfEdge, std::uint32_t low, std::uint32_t) { ++bucket[low + 1]; });
    for (std::size_t i = 1; i < bucket.size(); ++i)
        bucket[i] += bucket[i - 1];
    std::vector<Entry> entries(bucket.back());
    std::vector<std::uint32_t> next(bucket.begin(), bucket.end() - 1);
    forEachSide(
        [&](HalfEdge side, std::uint32_t low, std::uint32_t high) {
            entries[next[low]++] = {high, side};
        });

    parallelShares(positionCount, kLeastPositionsAThread,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       for (std::size_t low = first; low < last; ++low)
                           std::sort(entries.begin() + bucket[low], entries.begin() + bucket[low + 1]);
                   });
    _sides.reserve(entries.size());
    for (std::size_t low = 0; low < positionCount; ++low)
    {
        const auto begin = entries.begin() + bucket[low], end = entries.begin() + bucket[low + 1];
        for (auto entry = begin; entry != end; ++entry)
        {
            if (entry == begin || entry->high != (entry - 1)->high)
                _first.push_back(static_cast<std::uint32_t>(_sides.size()));
            _edgeOfSide[entry->side] = static_cast<std::uint32_t>(_first.size() - 1);
            _sides.push_back(entry->side);
        }
    }
    _first.push_back(static_cast<std::uint32_t>(_sides.size()));
}

bool EdgeTable::describes(std::span<const Triangle> triangles) const
{
    if (_edgeOfSide.size() != 3 * triangles.size()) return false;
    std::set<std::pair<std::uint32_t, std::uint32_t>> known;
    std::size_t listed = 0, withLength = 0;
    for (std::uint32_t edge = 0; edge < size(); ++edge)
    {
        if (sides(edge).empty()) return false;
        const auto ends = sortedEnds(triangles, sides(edge).front());
        if (ends.first == ends.second || !known.insert(ends).second) return false;
        for (const HalfEdge side : sides(edge))
        {
            if (_edgeOfSide[side] != edge || sortedEnds(triangles, side) != ends) return false;
            ++listed;
        }
    }
    for (HalfEdge side = 0; side < _edgeOfSide.size(); ++side)
    {
        const auto [low, high] = sortedEnds(triangles, side);
        withLength += low != high;
        if ((low == high) != (_edgeOfSide[side] == kNone)) return false;
    }
    return listed == withLength;
}

} // namespace osgPMObjects::core
