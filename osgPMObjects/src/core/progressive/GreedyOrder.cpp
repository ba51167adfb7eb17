// SPDX-License-Identifier: Apache-2.0
#include "GreedyOrder.h"

#include <algorithm>
#include <array>

#include <foundation/VertexCache.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kFacesOfLine = 10; // in 64 bytes of 16-bit indices

/// Builds the greedy order triangle by triangle. Source: see greedyOrder().
class GreedyBuffer
{
public:
    GreedyBuffer(std::span<const Triangle> triangles, std::uint32_t vertexCount, std::uint32_t cacheSize,
                 const GreedyWeights& weights, std::vector<bool> isTouched)
        : _triangles(triangles),
          _weights(weights),
          _isTouched(std::move(isTouched)),
          _cache(vertexCount, cacheSize),
          _isPlaced(triangles.size(), false),
          _trianglesOf(vertexCount),
          _recent(cacheSize)
    {
        _isTouched.resize(triangles.size() / kFacesOfLine * kFacesOfLine + kFacesOfLine, false);
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            for (const std::uint32_t vertex : triangles[t])
                _trianglesOf[vertex].push_back(t);
    }

    std::vector<std::uint32_t> order()
    {
        std::vector<std::uint32_t> order;
        for (std::uint32_t position = 0; position < _triangles.size(); ++position)
        {
            const std::uint32_t t = position == 0 ? 0 : bestFor(position);
            order.push_back(t);
            append(t, position);
        }
        return order;
    }

private:
    std::uint32_t bestFor(std::uint32_t position)
    {
        _best = ~0u;
        _least = 1e9f;
        if (!_isPlaced[position]) consider(position, position);
        for (const std::uint32_t vertex : _recent)
            for (const std::uint32_t t : _trianglesOf[vertex])
                consider(t, position);
        if (_best != ~0u) return _best;
        while (_isPlaced[_firstLeft])
            ++_firstLeft;
        return _firstLeft;
    }

    void consider(std::uint32_t t, std::uint32_t position)
    {
        float cost = 0.0f;
        for (const std::uint32_t vertex : _triangles[t])
            cost += _cache.holds(vertex) ? 0.0f : 1.0f;
        if (t == position)
            cost -= _weights.stays;
        else if (_isTouched[t])
            cost -= _weights.lineTouched;
        if (cost > _least || (cost == _least && t >= _best)) return;
        _least = cost;
        _best = t;
    }

    void append(std::uint32_t t, std::uint32_t position)
    {
        _isPlaced[t] = true;
        if (t != position)
        {
            touchLineOf(position);
            touchLineOf(t);
        }
        for (const std::uint32_t vertex : _triangles[t])
        {
            if (_cache.transform(vertex)) _recent[_cache.misses() % _recent.size()] = vertex;
            std::erase(_trianglesOf[vertex], t);
        }
    }

    void touchLineOf(std::uint32_t position)
    {
        std::fill_n(_isTouched.begin() + position / kFacesOfLine * kFacesOfLine, kFacesOfLine, true);
    }

    std::span<const Triangle> _triangles;
    GreedyWeights _weights;
    std::vector<bool> _isTouched;
    foundation::FifoCache _cache;
    std::vector<bool> _isPlaced;
    std::vector<std::vector<std::uint32_t>> _trianglesOf; ///< by vertex: triangles left
    std::vector<std::uint32_t> _recent;                   ///< vertices in the cache
    std::uint32_t _firstLeft = 0, _best = 0;
    float _least = 0.0f;
};

} // namespace

std::vector<std::uint32_t> greedyOrder(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                       std::uint32_t cacheSize, const GreedyWeights& weights,
                                       std::vector<bool> isTouched)
{
    if (triangles.empty()) return {};
    return GreedyBuffer(triangles, vertexCount, cacheSize, weights, std::move(isTouched)).order();
}

} // namespace osgPMObjects::core
