// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// The triangles at each vertex, in the order of their numbers.
class VertexTriangles
{
public:
    VertexTriangles(std::span<const Triangle> triangles, std::uint32_t vertexCount)
        : _first(std::size_t(vertexCount) + 2, 0), _triangles(3 * triangles.size())
    {
        for (const Triangle& t : triangles)
            for (const std::uint32_t v : t)
                ++_first[v + 2];
        for (std::size_t i = 2; i < _first.size(); ++i)
            _first[i] += _first[i - 1];
        for (std::uint32_t t = 0; t < triangles.size(); ++t)
            for (const std::uint32_t v : triangles[t])
                _triangles[_first[v + 1]++] = t;
        _next.assign(_first.begin(), _first.end());
    }

    std::span<const std::uint32_t> at(std::uint32_t vertex) const
    {
        return std::span(_triangles).subspan(_first[vertex], _first[vertex + 1] - _first[vertex]);
    }

    /// Returns the next few triangles at a vertex, from the first one for which `isDone` is false. A vertex
    /// with thousands of triangles thus need not pass the done ones each time. What is done must stay done.
    template<class IsDone>
    std::span<const std::uint32_t> nextAt(std::uint32_t vertex, IsDone isDone)
    {
        std::uint32_t& next = _next[vertex];
        const std::uint32_t end = _first[vertex + 1];
        while (next < end && isDone(_triangles[next]))
            ++next;
        return std::span(_triangles).subspan(next, std::min(end - next, kFew));
    }

private:
    static constexpr std::uint32_t kFew = 64;

    std::vector<std::uint32_t> _first, _triangles;
    std::vector<std::uint32_t> _next; ///< by vertex: index of the first triangle that may not be done
};

} // namespace osgPMObjects::core
