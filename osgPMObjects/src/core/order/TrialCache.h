// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <foundation/VertexCache.h>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// A queue of vertices that can undo what was drawn since beginTrial().
class TrialCache
{
public:
    TrialCache(std::uint32_t vertexCount, std::uint32_t size) : _cache(vertexCount, size) {}

    /// Draws a triangle; returns how many of its vertices were transformed.
    std::uint32_t draw(const Triangle& triangle)
    {
        std::uint32_t misses = 0;
        for (const std::uint32_t vertex : triangle)
        {
            const std::uint64_t before = _cache.lastMiss(vertex);
            if (!_cache.transform(vertex)) continue;
            ++misses;
            if (_isTrial) _tried.emplace_back(vertex, before);
        }
        return misses;
    }

    void beginTrial() { _isTrial = true; }
    void endTrial()
    {
        for (; !_tried.empty(); _tried.pop_back())
            _cache.takeBack(_tried.back().first, _tried.back().second);
        _isTrial = false;
    }

    bool holds(std::uint32_t vertex) const { return _cache.holds(vertex); }
    std::uint32_t size() const { return _cache.size(); }

private:
    foundation::FifoCache _cache;
    std::vector<std::pair<std::uint32_t, std::uint64_t>>
        _tried; ///< vertices that entered during the trial, with their last miss before
    bool _isTrial = false;
};

} // namespace osgPMObjects::core
