// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/order/TriangleAdjacency.h>

#include "TrialCache.h"

namespace osgPMObjects::core
{

/// Lays strips side by side over a mesh and counts what they cost a queue of vertices. See localityOrder()
/// for the source.
class StripGrowth
{
public:
    static constexpr std::uint32_t kNone = TriangleAdjacency::kNone;

    /// A triangle at which a strip may begin, the edge through which it enters, and whether a strip lies to
    /// its right.
    struct Entry
    {
        std::uint32_t triangle;
        int edge;
        bool isBeside = false;
    };

    StripGrowth(std::span<const Triangle> triangles, std::uint32_t vertexCount, std::uint32_t cacheSize);

    /// Draws a strip of at most `length` triangles. Beside another strip it keeps to its right, else it goes
    /// straight on. The triangles on its left become the next entries; those ahead and on its right are kept
    /// for later.
    void grow(const Entry& start, std::size_t length);

    /// Returns the transformed vertices a triangle if this strip and the strips beside it have this length,
    /// by a trial over `triangles` triangles, which is undone. A trial that transforms more than `most` ·
    /// `triangles` vertices ends there and returns `most`.
    double costOf(const Entry& start, std::size_t length, std::size_t triangles, double most);

    /// Returns the first entry beside the latest strip that has one; it skips the oldest `kept` strips.
    /// kNone: none is left.
    Entry nextBeside(std::size_t kept = 0);
    /// Returns the latest entry ahead of a strip; kNone: none is left.
    Entry nextAhead();
    void pushAhead(const Entry& entry) { _ahead.push_back(entry); }

    /// Returns the cost of drawing a triangle: four for each vertex outside the queue, one for each neighbour
    /// not yet drawn.
    int completionCost(std::uint32_t triangle) const
    {
        return 4 * missesOf(triangle) + _openNeighbours[triangle];
    }
    /// Returns an edge through which to enter a triangle: one without an undrawn neighbour, if there is one.
    int borderEdge(std::uint32_t triangle) const;

    bool isDone(std::uint32_t triangle) const { return _isDone[triangle] != 0; }
    const TrialCache& cache() const { return _cache; }
    const std::vector<std::uint32_t>& order() const { return _order; }

private:
    /// The range of entries beside one strip, in _beside.
    struct Beside
    {
        std::size_t first, end;
    };

    /// Number of an absent neighbour: it is always done, so that no test for absence is needed.
    std::uint32_t outside() const { return static_cast<std::uint32_t>(_triangles.size()); }
    int missesOf(std::uint32_t t) const
    {
        const Triangle& corners = _triangles[t];
        return !_cache.holds(corners[0]) + !_cache.holds(corners[1]) + !_cache.holds(corners[2]);
    }
    void draw(std::uint32_t t);
    void undraw(std::uint32_t t);
    void fillHoles(std::uint32_t t);
    Entry entering(std::uint32_t from, int edge, bool isBeside) const
    {
        return {_neighbours[from][edge], _entryEdges[from][edge], isBeside};
    }
    void layStrip(Entry entry, std::size_t length);

    std::span<const Triangle> _triangles;
    std::vector<std::array<std::uint32_t, 3>> _neighbours; ///< by triangle and edge; outside(): none
    std::vector<std::array<std::uint8_t, 3>> _entryEdges;  ///< by triangle and edge: the neighbour's edge
    std::vector<std::uint8_t> _openNeighbours;             ///< by triangle: neighbours not yet drawn
    std::vector<char> _isDone;                             ///< by triangle, and of outside()
    TrialCache _cache;
    std::vector<std::uint32_t> _order;
    std::vector<Beside> _strips; ///< strips with entries beside them, the latest last
    std::vector<Entry> _beside,
        _ahead; ///< entries in the order in which they were found
    std::uint64_t _misses = 0;
};

} // namespace osgPMObjects::core
