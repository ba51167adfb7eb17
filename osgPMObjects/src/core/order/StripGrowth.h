// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/order/TriangleAdjacency.h>

#include "TrialCache.h"

namespace osgPMObjects::core
{

/// Strips that are laid side by side over a mesh, and what they cost a queue of vertices.
class StripGrowth
{
public:
    static constexpr std::uint32_t kNone = TriangleAdjacency::kNone;

    /// A triangle, and the edge through which a strip comes to it; whether there is a strip to the right of it.
    struct Place
    {
        std::uint32_t triangle;
        int edge;
        bool isBeside = false;
    };

    StripGrowth(std::span<const Triangle> triangles, std::uint32_t vertexCount, std::uint32_t cacheSize);

    /// Draws a strip of at most so many triangles. Beside another one it keeps to its right; alone it goes straight on. What
    /// lies on its left is where the next ones begin; what lies ahead and on its right has time.
    void grow(const Place& start, std::size_t length);

    /// Transforms per triangle when this strip and those beside it have that length, over so many triangles; they are taken
    /// back afterwards.
    double costOf(const Place& start, std::size_t length, std::size_t triangles);

    /// The first place left beside the latest strip that has one, but for the oldest `kept` strips; kNone, when there is none.
    Place nextBeside(std::size_t kept = 0);
    /// The latest place ahead of a strip; kNone, when there is none.
    Place nextOnward();
    void putOnward(const Place& place) { _onward.push_back(place); }

    /// Four for each vertex that is not in the queue, and one for each neighbour left.
    int leftAt(std::uint32_t triangle) const;
    /// An edge with nothing new across, to come in through.
    int rim(std::uint32_t triangle) const;

    bool isDone(std::uint32_t triangle) const { return _isDone[triangle] != 0; }
    const TrialCache& cache() const { return _cache; }
    const std::vector<std::uint32_t>& order() const { return _order; }

private:
    /// The places left beside one strip, in _beside.
    struct Beside
    {
        std::size_t first, end;
    };

    bool isOpen(std::uint32_t t) const { return t != kNone && !_isDone[t]; }
    void draw(std::uint32_t t);
    void fillHoles(std::uint32_t t);
    Place entering(std::uint32_t from, int edge, bool isBeside) const;
    void layStrip(Place place, std::size_t length);

    std::span<const Triangle> _triangles;
    TriangleAdjacency _adjacency;
    TrialCache _cache;
    std::vector<char> _isDone;
    std::vector<std::uint32_t> _order;
    std::vector<Beside> _strips; ///< those with places left beside them, the latest last
    std::vector<Place> _beside,
        _onward; ///< places where a strip may begin, in the order in which they were found
    std::uint64_t _misses = 0;
};

} // namespace osgPMObjects::core
