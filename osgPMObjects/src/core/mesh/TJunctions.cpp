// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/FirstAtPlace.h>
#include <osgPMObjects/core/mesh/PointTree.h>
#include <osgPMObjects/core/mesh/TJunctions.h>

namespace osgPMObjects::core
{

namespace
{

/// The least distance of a foot from an end, as a share of the edge; nearer vertices are a matter of welding.
constexpr double kEnd = 1e-4;
/// Edges that share a limit of work, and the least number of such groups for a thread.
constexpr std::size_t kEdgesOfAGroup = 1024, kLeastGroupsAThread = 4;
/// Limits where the tolerance is larger than the details of the mesh: boxes and points that are looked at for
/// each edge, and besides by a few edges near all points, together; junctions for each edge and vertex. Known
/// models need up to 160 boxes and points an edge of a group.
constexpr std::uint64_t kMostWorkAnEdge = 256, kMostWorkOfFew = 1u << 25;
constexpr std::size_t kMostJunctions = 4, kFewJunctions = 65536;

/// An edge, and the tests whether boxes and points lie near it.
class EdgeProbe
{
public:
    EdgeProbe(const glm::dvec3& a, const glm::dvec3& b, double tolerance)
        : _a(a), _along(b - a), _squaredLength(glm::dot(_along, _along)), _tolerance(tolerance)
    {
    }

    bool hasLength() const { return _squaredLength > 0.0; }

    /// Whether a box may hold points near the edge: between the planes at its ends, and within the tolerance
    /// of its line.
    bool operator()(const Extent& box) const
    {
        constexpr double kSlack = 1e-12;
        const glm::dvec3 half = 0.5 * (box.high - box.low), to = box.low + half - _a;
        const double share = glm::dot(to, _along);
        const double around =
            glm::dot(half, glm::abs(_along)) + kSlack * glm::dot(glm::abs(to), glm::abs(_along));
        if (share + around < 0.0 || share - around > _squaredLength) return false;
        const double off = glm::length(to - (share / _squaredLength) * _along);
        return !(off > _tolerance + glm::length(half) + kSlack * glm::length(to));
    }

    /// Returns the foot of a near point as a share of the edge, and its distance; nothing for others.
    std::optional<std::pair<double, double>> foot(const glm::dvec3& p) const // the ends have none
    {
        const glm::dvec3 toP = p - _a;
        const double share = glm::dot(toP, _along) / _squaredLength;
        if (!(share > kEnd && share < 1.0 - kEnd)) return {};
        const double distance = glm::length(toP - share * _along);
        if (!(distance <= _tolerance)) return {};
        return std::pair{share, distance};
    }

private:
    glm::dvec3 _a, _along;
    double _squaredLength, _tolerance;
};

/// Searches the open edges of a mesh for vertices near them.
class Search
{
public:
    Search(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles, const EdgeTable& edges,
           double tolerance, OpenEdges open, std::span<const std::uint8_t> among)
        : _positions(positions), _tolerance(tolerance)
    {
        std::vector<bool> isOpenVertex(positions.size(), false);
        for (std::uint32_t e = 0; e < edges.size(); ++e)
        {
            const std::size_t sides = edges.sides(e).size();
            if (sides == 2 || (sides > 2 && open == OpenEdges::boundary)) continue;
            const auto [from, to] = endsOf(triangles, edges.sides(e).front());
            if (!among.empty() && !(among[from] && among[to])) continue;
            _edges.push_back({e, std::minmax(from, to)});
            isOpenVertex[from] = isOpenVertex[to] = true;
        }
        gatherPlaces(isOpenVertex);
    }

    FoundTJunctions run() const
    {
        const PointTree tree(_places);
        std::atomic<bool> isCutShort = false;
        const std::size_t most = kMostJunctions * (_edges.size() + _vertices.size()) + kFewJunctions;
        std::vector<std::vector<TJunction>> found(foundation::processors());
        parallelShares(groupCount(), kLeastGroupsAThread,
                       [&](std::size_t first, std::size_t last, std::size_t share)
                       {
                           for (std::size_t g = first; g < last && found[share].size() < most; ++g)
                               if (!searchGroup(g, tree, found[share])) isCutShort = true;
                           if (found[share].size() >= most) isCutShort = true;
                       });
        FoundTJunctions result;
        std::vector<TJunction>& all = result.all;
        for (const std::vector<TJunction>& part : found)
        {
            const std::size_t taken = std::min(part.size(), most - all.size());
            all.insert(all.end(), part.begin(), part.begin() + std::ptrdiff_t(taken));
            result.isCutShort = result.isCutShort || taken < part.size();
        }
        result.isCutShort = result.isCutShort || isCutShort;
        return result;
    }

    /// Counts the vertices that are in some junction. A vertex that has been found is not looked for again,
    /// so this needs no memory for junctions.
    std::size_t countVertices() const
    {
        PointTree tree(_places);
        std::size_t count = 0;
        std::uint64_t work = workOf(_edges.size(), tree, 1);
        for (const OpenEdge& edge : _edges)
        {
            const EdgeProbe probe = probeOf(edge);
            if (!probe.hasLength()) continue;
            tree.extract(probe, work,
                         [&](std::uint32_t number)
                         {
                             const bool isFound = probe.foot(_places[number]).has_value();
                             if (isFound) count += verticesAt(number).size();
                             return isFound;
                         });
        }
        return count;
    }

private:
    struct OpenEdge
    {
        std::uint32_t edge;
        std::pair<std::uint32_t, std::uint32_t> ends;
    };

    /// Returns the most boxes and points to look at for some edges of as many groups; one edge may be near
    /// all points.
    static std::uint64_t workOf(std::size_t edges, const PointTree& tree, std::size_t groups)
    {
        return kMostWorkAnEdge * edges +
               std::min(16 * std::uint64_t{tree.nodeCount()}, kMostWorkOfFew / groups);
    }

    std::size_t groupCount() const { return (_edges.size() + kEdgesOfAGroup - 1) / kEdgesOfAGroup; }

    EdgeProbe probeOf(const OpenEdge& edge) const
    {
        return {_positions[edge.ends.first], _positions[edge.ends.second], _tolerance};
    }

    /// Gathers the open vertices by their places: those that a split of edges has made may lie a hundred deep
    /// at one, and each search is to look at it once.
    void gatherPlaces(const std::vector<bool>& isOpenVertex)
    {
        const std::vector<std::uint32_t> first = firstAtPlace(_positions);
        for (std::uint32_t v = 0; v < _positions.size(); ++v)
            if (isOpenVertex[v]) _vertices.push_back(v);
        std::stable_sort(_vertices.begin(), _vertices.end(),
                         [&](std::uint32_t v, std::uint32_t w) { return first[v] < first[w]; });
        for (std::uint32_t i = 0; i < _vertices.size(); ++i)
        {
            if (i > 0 && first[_vertices[i]] == first[_vertices[i - 1]]) continue;
            _places.push_back(_positions[_vertices[i]]);
            _firstVertex.push_back(i);
        }
        _firstVertex.push_back(static_cast<std::uint32_t>(_vertices.size()));
    }

    std::span<const std::uint32_t> verticesAt(std::uint32_t place) const
    {
        return std::span(_vertices).subspan(_firstVertex[place],
                                            _firstVertex[place + 1] - _firstVertex[place]);
    }

    /// Searches the edges of a group, in order. Returns whether it came to the end: its limit of work does
    /// not depend on the number of threads.
    bool searchGroup(std::size_t group, const PointTree& tree, std::vector<TJunction>& found) const
    {
        const std::size_t first = group * kEdgesOfAGroup;
        const std::size_t last = std::min(first + kEdgesOfAGroup, _edges.size());
        std::uint64_t work = workOf(last - first, tree, groupCount());
        for (std::size_t i = first; i < last; ++i)
        {
            const OpenEdge& edge = _edges[i];
            const EdgeProbe probe = probeOf(edge);
            const std::size_t before = found.size();
            if (!probe.hasLength()) continue;
            tree.visit(probe, work,
                       [&](std::uint32_t number)
                       {
                           const auto foot = probe.foot(_places[number]);
                           if (!foot) return;
                           for (const std::uint32_t vertex : verticesAt(number))
                               found.push_back({edge.edge, vertex, foot->first, foot->second});
                       });
            std::sort(found.begin() + std::ptrdiff_t(before), found.end(),
                      [](const TJunction& x, const TJunction& y)
                      { return x.along != y.along ? x.along < y.along : x.vertex < y.vertex; });
        }
        return work > 0;
    }

    std::span<const glm::dvec3> _positions;
    double _tolerance;
    std::vector<OpenEdge> _edges;
    std::vector<std::uint32_t> _vertices;    ///< of open edges, place by place
    std::vector<glm::dvec3> _places;         ///< the positions of these, each once
    std::vector<std::uint32_t> _firstVertex; ///< by place: its first in _vertices; one more at the end
};

} // namespace

FoundTJunctions findTJunctions(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                               const EdgeTable& edges, double tolerance, OpenEdges open,
                               std::span<const std::uint8_t> among)
{
    return Search(positions, triangles, edges, tolerance, open, among).run();
}

std::size_t countTVertices(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                           const EdgeTable& edges, double tolerance, OpenEdges open)
{
    return Search(positions, triangles, edges, tolerance, open, {}).countVertices();
}

} // namespace osgPMObjects::core
