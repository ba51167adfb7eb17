// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <deque>
#include <optional>

#include <osgPMObjects/core/order/TriangleStrips.h>

#include "TrialCache.h"
#include "VertexTriangles.h"

namespace osgPMObjects::core
{

namespace
{

constexpr std::size_t kMostTriedStrips = 64;

/// Chooses the next strip by simulating the vertex cache. Source: see cacheOrderedStrips().
class StripSorter
{
public:
    StripSorter(std::span<const Triangle> triangles, std::uint32_t vertexCount, const TriangleStrips& strips,
                std::uint32_t cacheSize)
        : _triangles(triangles),
          _strips(strips),
          _atVertex(triangles, vertexCount),
          _cache(vertexCount, cacheSize),
          _stripOf(triangles.size()),
          _isDone(strips.size(), 0),
          _tried(strips.size(), 0)
    {
        for (std::uint32_t s = 0; s < strips.size(); ++s)
            for (const std::uint32_t t : strips.strip(s))
                _stripOf[t] = s;
    }

    TriangleStrips run()
    {
        for (std::uint32_t next = 0; next < _strips.size(); ++next)
        {
            if (_isDone[next]) continue;
            take({next, false});
            while (const auto best = cheapest())
                take(*best);
        }
        return std::move(_result);
    }

private:
    struct Choice
    {
        std::uint32_t strip;
        bool isBackward;
    };

    std::uint32_t triangleOf(const Choice& choice, std::size_t k) const
    {
        const auto strip = _strips.strip(choice.strip);
        return strip[choice.isBackward ? strip.size() - 1 - k : k];
    }

    /// Returns the transforms a triangle at the beginning of a strip.
    double costOf(const Choice& choice)
    {
        const std::size_t size = std::min<std::size_t>(_strips.strip(choice.strip).size(), 2 * _cache.size());
        std::uint32_t misses = 0;
        _cache.beginTrial();
        for (std::size_t k = 0; k < size; ++k)
            misses += _cache.draw(_triangles[triangleOf(choice, k)]);
        _cache.endTrial();
        return static_cast<double>(misses) / static_cast<double>(size);
    }

    /// Returns the best strip among those with a vertex in the queue, newest vertices first; nothing if there
    /// is none.
    std::optional<Choice> cheapest()
    {
        ++_trial;
        std::optional<Choice> best;
        double least = 0.0;
        std::size_t tried = 0;
        for (auto vertex = _recent.rbegin(); vertex != _recent.rend(); ++vertex)
            for (const std::uint32_t t :
                 _atVertex.nextAt(*vertex, [this](std::uint32_t o) { return _isDone[_stripOf[o]] != 0; }))
            {
                const std::uint32_t strip = _stripOf[t];
                if (_isDone[strip] || _tried[strip] == _trial) continue;
                if (++tried > kMostTriedStrips) return best;
                _tried[strip] = _trial;
                for (const bool isBackward : {false, true})
                    if (const double cost = costOf({strip, isBackward}); !best || cost < least)
                    {
                        best = {strip, isBackward};
                        least = cost;
                    }
            }
        return best;
    }

    void take(const Choice& choice)
    {
        _isDone[choice.strip] = 1;
        _result.firsts.push_back(static_cast<std::uint32_t>(_result.triangles.size()));
        for (std::size_t k = 0; k < _strips.strip(choice.strip).size(); ++k)
        {
            const std::uint32_t t = triangleOf(choice, k);
            _result.triangles.push_back(t);
            for (const std::uint32_t vertex : _triangles[t])
                if (!_cache.holds(vertex)) _recent.push_back(vertex);
            _cache.draw(_triangles[t]);
        }
        while (_recent.size() > _cache.size())
            _recent.pop_front();
    }

    std::span<const Triangle> _triangles;
    const TriangleStrips& _strips;
    VertexTriangles _atVertex;
    TrialCache _cache;
    std::vector<std::uint32_t> _stripOf;
    std::vector<char> _isDone;
    std::vector<std::uint32_t> _tried;
    std::uint32_t _trial = 0;
    std::deque<std::uint32_t> _recent; ///< vertices in the queue, oldest first
    TriangleStrips _result;
};

} // namespace

TriangleStrips cacheOrderedStrips(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                                  const TriangleStrips& strips, std::uint32_t cacheSize)
{
    return StripSorter(triangles, vertexCount, strips, cacheSize).run();
}

} // namespace osgPMObjects::core
