// SPDX-License-Identifier: Apache-2.0
#include "GreedyOrder.h"

#include <algorithm>
#include <array>

#include <foundation/VertexCache.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kPlacesOfLine = 10; // 64 bytes of 16-bit indices

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
        _isTouched.resize(triangles.size() / kPlacesOfLine * kPlacesOfLine + kPlacesOfLine, false);
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            for (const std::uint32_t vertex : triangles[t])
                _trianglesOf[vertex].push_back(t);
    }

    std::vector<std::uint32_t> order()
    {
        std::vector<std::uint32_t> order;
        for (std::uint32_t place = 0; place < _triangles.size(); ++place)
        {
            const std::uint32_t t = place == 0 ? 0 : bestFor(place);
            order.push_back(t);
            append(t, place);
        }
        return order;
    }

private:
    std::uint32_t bestFor(std::uint32_t place)
    {
        _best = ~0u;
        _least = 1e9f;
        if (!_isPlaced[place]) consider(place, place);
        for (const std::uint32_t vertex : _recent)
            for (const std::uint32_t t : _trianglesOf[vertex])
                consider(t, place);
        if (_best != ~0u) return _best;
        while (_isPlaced[_firstLeft])
            ++_firstLeft;
        return _firstLeft;
    }

    void consider(std::uint32_t t, std::uint32_t place)
    {
        float cost = 0.0f;
        for (const std::uint32_t vertex : _triangles[t])
            cost += _cache.holds(vertex) ? 0.0f : 1.0f;
        if (t == place)
            cost -= _weights.stays;
        else if (_isTouched[t])
            cost -= _weights.lineTouched;
        if (cost > _least || (cost == _least && t >= _best)) return;
        _least = cost;
        _best = t;
    }

    void append(std::uint32_t t, std::uint32_t place)
    {
        _isPlaced[t] = true;
        if (t != place)
        {
            touchLineOf(place);
            touchLineOf(t);
        }
        for (const std::uint32_t vertex : _triangles[t])
        {
            if (_cache.transform(vertex)) _recent[_cache.misses() % _recent.size()] = vertex;
            std::erase(_trianglesOf[vertex], t);
        }
    }

    void touchLineOf(std::uint32_t place)
    {
        std::fill_n(_isTouched.begin() + place / kPlacesOfLine * kPlacesOfLine, kPlacesOfLine, true);
    }

    std::span<const Triangle> _triangles;
    GreedyWeights _weights;
    std::vector<bool> _isTouched;
    foundation::FifoCache _cache;
    std::vector<bool> _isPlaced;
    std::vector<std::vector<std::uint32_t>> _trianglesOf; ///< by vertex: those left
    std::vector<std::uint32_t> _recent;                   ///< what the cache holds
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
