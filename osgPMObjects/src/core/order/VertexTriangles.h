// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// The triangles at each vertex, by number.
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
    }

    std::span<const std::uint32_t> at(std::uint32_t vertex) const
    {
        return std::span(_triangles).subspan(_first[vertex], _first[vertex + 1] - _first[vertex]);
    }

private:
    std::vector<std::uint32_t> _first, _triangles;
};

} // namespace osgPMObjects::core
