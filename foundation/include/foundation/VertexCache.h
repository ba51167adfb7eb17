// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foundation
{

/// A model of a first-in-first-out vertex cache: the vertices that were transformed last. A vertex found in
/// it costs nothing and keeps its position in the queue.
/// Memory: 8 B a vertex. Cost: a few ns a call.
/// Source: Hoppe, *Optimization of Mesh Locality for Transparent Vertex Caching*, 1999, section 3.
class FifoCache
{
public:
    FifoCache(std::uint32_t vertexCount, std::uint32_t size) : _size(size), _lastMiss(vertexCount) {}

    /// Tells whether a vertex is in the cache.
    bool holds(std::uint32_t vertex) const
    {
        return _lastMiss[vertex] > _emptiedAt && _misses - _lastMiss[vertex] < _size;
    }

    /// Uses a vertex. Returns true when it was not in the cache and had to be transformed.
    bool transform(std::uint32_t vertex)
    {
        if (holds(vertex)) return false;
        _lastMiss[vertex] = ++_misses;
        return true;
    }

    /// Takes back the last transform() that returned true. `before`: lastMiss() of the vertex before it.
    void takeBack(std::uint32_t vertex, std::uint64_t before)
    {
        _lastMiss[vertex] = before;
        --_misses;
    }
    std::uint64_t lastMiss(std::uint32_t vertex) const { return _lastMiss[vertex]; }

    void empty() { _emptiedAt = _misses; }
    std::uint64_t misses() const { return _misses; }
    std::uint32_t size() const { return _size; }

private:
    std::uint64_t _size, _misses = 0, _emptiedAt = 0;
    std::vector<std::uint64_t> _lastMiss; ///< by vertex: number of the miss that brought it in; 0: none
};

/// The limits at which a graphics card that works in batches begins a new batch.
struct BatchLimits
{
    std::uint32_t vertices = std::numeric_limits<std::uint32_t>::max();  ///< distinct vertices
    std::uint32_t triangles = std::numeric_limits<std::uint32_t>::max(); ///< three indices each
};

/// A model of batched vertex processing: triangles of one batch share their transformed vertices, batches
/// share none. A triangle that would exceed a limit begins the next batch.
/// Memory: 4 B a vertex.
/// Source: Kerbl et al., *Revisiting the Vertex Cache*, 2018: an NVIDIA GTX 1080 was measured to work so,
/// with 32 distinct vertices and 96 indices a batch (kNvidia), and not with a queue.
class BatchCache
{
public:
    static constexpr BatchLimits kNvidia{32, 32};

    BatchCache(std::uint32_t vertexCount, const BatchLimits& limits)
        : _limits(limits), _lastBatch(vertexCount)
    {
    }

    void draw(std::span<const std::uint32_t, 3> triangle)
    {
        if (_triangles == _limits.triangles || _vertices + fresh(triangle) > _limits.vertices) begin();
        ++_triangles;
        for (const std::uint32_t vertex : triangle)
            if (_lastBatch[vertex] != _batch)
            {
                _lastBatch[vertex] = _batch;
                ++_vertices;
                ++_misses;
            }
    }

    /// Begins a new batch with the next triangle.
    void begin()
    {
        ++_batch;
        _vertices = _triangles = 0;
    }

    std::uint64_t misses() const { return _misses; }

private:
    std::uint32_t fresh(std::span<const std::uint32_t, 3> t) const
    {
        const auto isFresh = [this](std::uint32_t vertex) { return _lastBatch[vertex] != _batch; };
        return isFresh(t[0]) + (isFresh(t[1]) && t[1] != t[0]) +
               (isFresh(t[2]) && t[2] != t[0] && t[2] != t[1]);
    }

    BatchLimits _limits;
    std::vector<std::uint32_t> _lastBatch; ///< by vertex: the last batch that transformed it
    std::uint64_t _misses = 0;
    std::uint32_t _batch = 1, _vertices = 0, _triangles = 0;
};

} // namespace foundation
