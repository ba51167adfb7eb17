// SPDX-License-Identifier: Apache-2.0
#include "LaterOrder.h"

#include <algorithm>

#include <foundation/VertexCache.h>

#include "../order/VertexTriangles.h"

namespace osgPMObjects::core
{

namespace
{

class TriangleInserter
{
public:
    TriangleInserter(std::span<const Triangle> triangles, std::uint32_t vertexCount,
                     std::span<const std::uint32_t> order, std::uint32_t cacheSize)
        : _triangles(triangles),
          _given(order),
          _atVertex(triangles, vertexCount),
          _cache(vertexCount, cacheSize),
          _isSettled(triangles.size(), 0),
          _givenLeft(vertexCount, 0)
    {
        for (const std::uint32_t t : order)
        {
            _isSettled[t] = 1;
            for (const std::uint32_t vertex : triangles[t])
                ++_givenLeft[vertex];
        }
    }

    std::vector<std::uint32_t> run()
    {
        _order.reserve(_triangles.size());
        for (const std::uint32_t t : _given)
        {
            for (const std::uint32_t vertex : _triangles[t])
                --_givenLeft[vertex];
            draw(t);
            insertAround(t);
        }
        for (std::uint32_t t = 0; t < _triangles.size(); ++t)
            if (!_isSettled[t]) draw(t);
        return std::move(_order);
    }

private:
    void draw(std::uint32_t t)
    {
        _isSettled[t] = 1;
        _order.push_back(t);
        for (const std::uint32_t vertex : _triangles[t])
            _cache.transform(vertex);
    }

    void insertAround(std::uint32_t drawn)
    {
        _around.assign(1, drawn);
        while (!_around.empty())
        {
            const Triangle& corners = _triangles[_around.back()];
            _around.pop_back();
            for (const std::uint32_t vertex : corners)
                for (const std::uint32_t t :
                     _atVertex.nextAt(vertex, [this](std::uint32_t o) { return _isSettled[o] != 0; }))
                    if (!_isSettled[t] && (isHeld(t) || isLast(t)))
                    {
                        draw(t);
                        _around.push_back(t);
                    }
        }
    }

    bool isHeld(std::uint32_t t) const
    {
        return std::all_of(_triangles[t].begin(), _triangles[t].end(),
                           [this](std::uint32_t vertex) { return _cache.holds(vertex); });
    }

    /// Tells whether no triangle of the given order will come to a vertex of this one.
    bool isLast(std::uint32_t t) const
    {
        return std::all_of(_triangles[t].begin(), _triangles[t].end(),
                           [this](std::uint32_t vertex) { return _givenLeft[vertex] == 0; });
    }

    std::span<const Triangle> _triangles;
    std::span<const std::uint32_t> _given;
    VertexTriangles _atVertex;
    foundation::FifoCache _cache;
    std::vector<char> _isSettled;          ///< by triangle: drawn, or in the given order
    std::vector<std::uint32_t> _givenLeft; ///< by vertex: triangles of the given order not yet drawn
    std::vector<std::uint32_t> _around;    ///< triangles whose vertices are to be looked at
    std::vector<std::uint32_t> _order;
};

} // namespace

std::vector<std::uint32_t> withTrianglesLeftOut(std::span<const Triangle> triangles,
                                                std::uint32_t vertexCount,
                                                std::span<const std::uint32_t> order, std::uint32_t cacheSize)
{
    return TriangleInserter(triangles, vertexCount, order, cacheSize).run();
}

} // namespace osgPMObjects::core
