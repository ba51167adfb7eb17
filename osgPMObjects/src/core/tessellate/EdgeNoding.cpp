// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <osgPMObjects/core/tessellate/EdgeNoding.h>

#include "EdgeContacts.h"
#include "EdgeCrossing.h"

namespace osgPMObjects::core
{

namespace
{

// Exponents of the cell size of grids (powers of two), for coordinates of at most 1.
constexpr int kFinestGrid = -46;   ///< to which crossings are rounded
constexpr int kCoarsestGrid = -20; ///< to which corners may be moved, at worst
constexpr int kRounds = 24;        ///< rounds of dividing edges before the grid grows coarser

/// A part of the contour edge that begins at `corner`.
struct Part
{
    EdgeEnds ends;
    std::int32_t winding;
    std::uint32_t corner, nextCorner;
};

/// Divides the parts of edges until no two meet. Source: see nodeEdges().
class Noder
{
public:
    Noder(std::span<const glm::dvec2> corners, std::span<const std::uint32_t> contourSizes)
        : _corners(corners), _contourSizes(contourSizes)
    {
    }

    std::optional<NodedEdges> run()
    {
        for (int exponent = kFinestGrid; exponent <= kCoarsestGrid; exponent += 2)
        {
            begin(exponent);
            for (int round = 0; round < kRounds; ++round)
                if (!divide()) return finished();
        }
        return std::nullopt;
    }

private:
    using Coordinates = std::pair<double, double>;

    /// Returns the number of the point at a position, and whether it is new.
    std::pair<std::uint32_t, bool> pointAt(const glm::dvec2& position)
    {
        const auto number = static_cast<std::uint32_t>(_noded.points.size());
        const auto [at, isNew] = _byPosition.try_emplace(Coordinates(position.x, position.y), number);
        return {at->second, isNew};
    }

    void begin(int exponent)
    {
        _grid = std::ldexp(1.0, exponent);
        const bool snaps = exponent > kFinestGrid;
        _noded = {};
        _noded.isSnapped = snaps;
        _byPosition.clear();
        std::vector<std::uint32_t> first(_corners.size());
        for (std::size_t i = 0; i < _corners.size(); ++i)
        {
            const glm::dvec2 position = snaps ? onGrid(_corners[i], _grid) : _corners[i];
            const auto [number, isNew] = pointAt(position);
            _noded.points.push_back(position);
            first[i] = number;
            if (!isNew) ++_noded.mergedCorners;
        }
        _parts.clear();
        std::uint32_t begin = 0;
        for (const std::uint32_t size : _contourSizes)
        {
            for (std::uint32_t i = 0; i < size; ++i)
            {
                const std::uint32_t corner = begin + i, next = begin + (i + 1) % size;
                _parts.push_back({{first[corner], first[next]}, 1, corner, next});
            }
            begin += size;
        }
        uniteEqualParts();
    }

    /// Merges edges so that each pair of points is joined at most once, from the lower number to the higher.
    void uniteEqualParts()
    {
        for (Part& part : _parts)
            if (part.ends[0] > part.ends[1])
            {
                std::swap(part.ends[0], part.ends[1]);
                part.winding = -part.winding;
            }
        std::sort(_parts.begin(), _parts.end(),
                  [](const Part& a, const Part& b)
                  { return std::tie(a.ends, a.corner) < std::tie(b.ends, b.corner); });
        std::vector<Part> united;
        for (const Part& part : _parts)
        {
            if (part.ends[0] == part.ends[1]) continue;
            if (!united.empty() && united.back().ends == part.ends)
                united.back().winding += part.winding;
            else
                united.push_back(part);
        }
        std::erase_if(united, [](const Part& part) { return part.winding == 0; });
        _parts = std::move(united);
    }

    /// Divides the parts where they meet. Returns whether any did.
    bool divide()
    {
        std::vector<EdgeEnds> edges;
        for (const Part& part : _parts)
            edges.push_back(part.ends);
        _cuts.assign(_parts.size(), {});
        bool any = false;
        const std::vector<glm::dvec2> points =
            _noded.points; // a copy: crossings are appended to the original
        forEachContact(points, edges,
                       [&](std::uint32_t i, std::uint32_t j, const EdgeContact& contact)
                       {
                           any = true;
                           for (int end = 0; end < 2; ++end)
                           {
                               if (contact.endInFirst[end]) _cuts[i].push_back(edges[j][end]);
                               if (contact.endInSecond[end]) _cuts[j].push_back(edges[i][end]);
                           }
                           if (contact.crosses) cross(i, j);
                       });
        if (any) applyCuts();
        return any;
    }

    void cross(std::uint32_t i, std::uint32_t j)
    {
        ++_noded.crossings;
        const glm::dvec2 position = crossingOf(_noded.points, _parts[i].ends, _parts[j].ends, _grid);
        for (const std::uint32_t part : {i, j})
            for (const std::uint32_t end : _parts[part].ends)
                if (const glm::dvec2 way = glm::abs(_noded.points[end] - position);
                    way.x <= _grid && way.y <= _grid)
                    return cutBoth(i, j, end);
        const auto [number, isNew] = pointAt(position);
        if (isNew)
        {
            _noded.points.push_back(position);
            _noded.inserted.push_back(
                betweenCorners(_corners, {contourEdge(_parts[i]), contourEdge(_parts[j])}, position));
        }
        cutBoth(i, j, number);
    }

    static EdgeEnds contourEdge(const Part& part) { return {part.corner, part.nextCorner}; }

    void cutBoth(std::uint32_t i, std::uint32_t j, std::uint32_t point)
    {
        for (const std::uint32_t part : {i, j})
            if (point != _parts[part].ends[0] && point != _parts[part].ends[1]) _cuts[part].push_back(point);
    }

    void applyCuts()
    {
        std::vector<Part> divided;
        for (std::size_t i = 0; i < _parts.size(); ++i)
        {
            Part part = _parts[i];
            const std::uint32_t last = part.ends[1];
            for (const std::uint32_t cut : alongPart(part, std::move(_cuts[i])))
            {
                part.ends[1] = cut;
                divided.push_back(part);
                part.ends[0] = cut;
            }
            part.ends[1] = last;
            divided.push_back(part);
        }
        _parts = std::move(divided);
        uniteEqualParts();
    }

    /// Returns the cuts of a part in order along it, each once.
    std::vector<std::uint32_t> alongPart(const Part& part, std::vector<std::uint32_t> cuts) const
    {
        const glm::dvec2 from = _noded.points[part.ends[0]], along = _noded.points[part.ends[1]] - from;
        const int axis = std::abs(along.x) >= std::abs(along.y) ? 0 : 1;
        const double sign = along[axis] < 0.0 ? -1.0 : 1.0, otherSign = along[1 - axis] < 0.0 ? -1.0 : 1.0;
        const auto key = [&](std::uint32_t cut)
        {
            const glm::dvec2& position = _noded.points[cut];
            return std::tuple(sign * position[axis], otherSign * position[1 - axis], cut);
        };
        std::sort(cuts.begin(), cuts.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
        return cuts;
    }

    NodedEdges finished()
    {
        for (const Part& part : _parts)
            _noded.edges.push_back({part.ends[0], part.ends[1], part.winding});
        return std::move(_noded);
    }

    std::span<const glm::dvec2> _corners;
    std::span<const std::uint32_t> _contourSizes;
    double _grid = 0.0;
    NodedEdges _noded;
    std::map<Coordinates, std::uint32_t> _byPosition;
    std::vector<Part> _parts;
    std::vector<std::vector<std::uint32_t>> _cuts; ///< by part: points at which it will be divided
};

} // namespace

std::optional<NodedEdges> nodeEdges(std::span<const glm::dvec2> corners,
                                    std::span<const std::uint32_t> contourSizes)
{
    return Noder(corners, contourSizes).run();
}

bool isNoded(const NodedEdges& noded)
{
    std::vector<EdgeEnds> edges;
    for (const NodedEdge& edge : noded.edges)
        edges.push_back({edge.from, edge.to});
    bool isClean = true;
    forEachContact(noded.points, edges,
                   [&](std::uint32_t, std::uint32_t, const EdgeContact&) { isClean = false; });
    std::sort(edges.begin(), edges.end());
    return isClean && std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

} // namespace osgPMObjects::core
