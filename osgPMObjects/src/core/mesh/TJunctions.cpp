// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <thread>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/PointGrid.h>
#include <osgPMObjects/core/mesh/TJunctions.h>

namespace osgPMObjects::core
{

namespace
{

/// The least distance of a foot from an end, as a share of the edge; nearer vertices are a matter of welding.
constexpr double kEnd = 1e-4;
/// The least number of edges for a thread.
constexpr std::size_t kLeastEdgesAThread = 4096;

using Ends = std::pair<std::uint32_t, std::uint32_t>;

/// Searches the open edges of a mesh for vertices near them.
class Search
{
public:
    Search(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles, const EdgeTable& edges,
           double tolerance, OpenEdges open, std::span<const std::uint8_t> among)
        : _positions(positions), _tolerance(tolerance)
    {
        std::vector<bool> isOpenVertex(positions.size(), false);
        double lengths = 0.0;
        for (std::uint32_t e = 0; e < edges.size(); ++e)
        {
            const std::size_t sides = edges.sides(e).size();
            if (sides == 2 || (sides > 2 && open == OpenEdges::boundary)) continue;
            const auto [from, to] = endsOf(triangles, edges.sides(e).front());
            if (!among.empty() && !(among[from] && among[to])) continue;
            _edges.push_back({e, std::minmax(from, to)});
            isOpenVertex[from] = isOpenVertex[to] = true;
            lengths += glm::length(positions[from] - positions[to]);
        }
        for (std::uint32_t v = 0; v < positions.size(); ++v)
            if (isOpenVertex[v]) _vertices.push_back(v);
        _cell = cellSize(lengths);
    }

    std::vector<TJunction> run() const
    {
        PointGrid grid(_cell, _vertices.size());
        for (const std::uint32_t v : _vertices)
            grid.add(_positions[v]);
        std::vector<std::vector<TJunction>> found(std::max(1u, std::thread::hardware_concurrency()));
        parallelShares(_edges.size(), kLeastEdgesAThread,
                       [&](std::size_t first, std::size_t last, std::size_t share)
                       {
                           for (std::size_t i = first; i < last; ++i)
                               searchEdge(_edges[i], grid, found[share]);
                       });
        std::vector<TJunction> all;
        for (const std::vector<TJunction>& part : found)
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }

private:
    struct OpenEdge
    {
        std::uint32_t edge;
        Ends ends;
    };

    /// Returns a cell size of the mean edge length, so that all edges together cross a few cells each, but at most 2^20 cells a
    /// side.
    double cellSize(double lengths) const
    {
        const double mean = _edges.empty() ? 0.0 : lengths / static_cast<double>(_edges.size());
        const double smallest = extentOf(_positions).diagonal() / (1 << 20);
        return std::max({mean, 4.0 * _tolerance, smallest, 1e-300});
    }

    void searchEdge(const OpenEdge& edge, const PointGrid& grid, std::vector<TJunction>& found) const
    {
        const glm::dvec3 a = _positions[edge.ends.first], b = _positions[edge.ends.second];
        const glm::dvec3 along = b - a;
        const double squaredLength = glm::dot(along, along);
        const std::size_t before = found.size();
        const auto visit = [&](std::uint32_t number)
        {
            const std::uint32_t v = _vertices[number];
            if (v == edge.ends.first || v == edge.ends.second) return;
            const glm::dvec3 toV = _positions[v] - a;
            const double share = glm::dot(toV, along) / squaredLength;
            if (!(share > kEnd && share < 1.0 - kEnd)) return;
            const double distance = glm::length(toV - share * along);
            if (distance <= _tolerance) found.push_back({edge.edge, v, share, distance});
        };
        const int pieces = std::max(1, static_cast<int>(std::ceil(std::sqrt(squaredLength) / _cell)));
        for (int i = 0; i < pieces; ++i)
        {
            const glm::dvec3 p = a + along * (static_cast<double>(i) / pieces);
            const glm::dvec3 q = a + along * (static_cast<double>(i + 1) / pieces);
            grid.visitBox(glm::min(p, q) - _tolerance, glm::max(p, q) + _tolerance, visit);
        }
        sortAlong(found, before);
    }

    /// Sorts the junctions found since `before` along the edge, and removes repeated ones.
    static void sortAlong(std::vector<TJunction>& found, std::size_t before)
    {
        const auto begin = found.begin() + static_cast<std::ptrdiff_t>(before);
        std::sort(begin, found.end(),
                  [](const TJunction& x, const TJunction& y)
                  { return x.along != y.along ? x.along < y.along : x.vertex < y.vertex; });
        found.erase(std::unique(begin, found.end(),
                                [](const TJunction& x, const TJunction& y) { return x.vertex == y.vertex; }),
                    found.end());
    }

    std::span<const glm::dvec3> _positions;
    double _tolerance;
    std::vector<OpenEdge> _edges;
    std::vector<std::uint32_t> _vertices; ///< of open edges, by their number in the grid
    double _cell = 1.0;
};

} // namespace

std::vector<TJunction> findTJunctions(std::span<const glm::dvec3> positions,
                                      std::span<const Triangle> triangles, const EdgeTable& edges,
                                      double tolerance, OpenEdges open, std::span<const std::uint8_t> among)
{
    return Search(positions, triangles, edges, tolerance, open, among).run();
}

std::size_t countVertices(std::span<const TJunction> junctions)
{
    std::vector<std::uint32_t> vertices;
    for (const TJunction& t : junctions)
        vertices.push_back(t.vertex);
    std::sort(vertices.begin(), vertices.end());
    return static_cast<std::size_t>(std::unique(vertices.begin(), vertices.end()) - vertices.begin());
}

} // namespace osgPMObjects::core
