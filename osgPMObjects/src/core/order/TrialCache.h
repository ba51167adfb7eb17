// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// A queue of vertices (foundation::FifoCache) that can undo what was drawn since beginTrial(). Misses are
/// counted in 32 bits, which suffices for 10^9 triangles and halves the memory that trials touch.
class TrialCache
{
public:
    TrialCache(std::uint32_t vertexCount, std::uint32_t size)
        : _size(size), _misses(size), _lastMiss(vertexCount, 0)
    {
    }

    /// Draws a triangle; returns how many of its vertices were transformed.
    std::uint32_t draw(const Triangle& triangle)
    {
        const std::uint32_t before = _misses;
        for (const std::uint32_t vertex : triangle)
        {
            if (holds(vertex)) continue;
            if (_isTrial) _tried.emplace_back(vertex, _lastMiss[vertex]);
            _lastMiss[vertex] = ++_misses;
        }
        return _misses - before;
    }

    void beginTrial() { _isTrial = true; }
    void endTrial()
    {
        _misses -= static_cast<std::uint32_t>(_tried.size());
        for (; !_tried.empty(); _tried.pop_back())
            _lastMiss[_tried.back().first] = _tried.back().second;
        _isTrial = false;
    }

    bool holds(std::uint32_t vertex) const { return _misses - _lastMiss[vertex] < _size; }
    std::uint32_t size() const { return _size; }

private:
    std::uint32_t _size;
    std::uint32_t _misses;                ///< begins at the size, so that no vertex is held at first
    std::vector<std::uint32_t> _lastMiss; ///< by vertex: number of the miss that brought it in; 0: none
    std::vector<std::pair<std::uint32_t, std::uint32_t>>
        _tried; ///< vertices that entered during the trial, with their last miss before
    bool _isTrial = false;
};

} // namespace osgPMObjects::core
