// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

#include <foundation/Angle.h>
#include <glm/common.hpp>

#include <osgPMObjects/core/bake/Charts.h>
#include <osgPMObjects/core/mesh/EdgeTable.h>

#include "FlatFaces.h"

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kNoChart = ~0u;

/// Grows charts, one after the other.
class ChartGrowth
{
public:
    ChartGrowth(const Mesh& mesh, const ChartSettings& settings)
        : _mesh(mesh),
          _triangles(positionTriangles(mesh)),
          _edges(_triangles, mesh.positions.size()),
          _leastCosine(std::cos(foundation::radiansOf(settings.mostSlantDeg))),
          _visited(mesh.faces.size(), 0)
    {
        charts.chartOfFace.assign(mesh.faces.size(), kNoChart);
        for (const Triangle& t : _triangles)
            _areas.push_back(glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
    }

    void growAll()
    {
        std::vector<std::uint32_t> seeds(_triangles.size());
        std::iota(seeds.begin(), seeds.end(), 0u);
        std::stable_sort(seeds.begin(), seeds.end(),
                         [&](std::uint32_t a, std::uint32_t b)
                         { return glm::dot(_areas[a], _areas[a]) > glm::dot(_areas[b], _areas[b]); });
        for (const std::uint32_t seed : seeds)
            while (charts.chartOfFace[seed] == kNoChart)
                growFrom(seed);
    }

    Charts charts;

private:
    const glm::dvec3& at(std::uint32_t position) const { return _mesh.positions[position]; }

    /// Returns the cosine between a face's normal and a unit direction; 1 for a face without area.
    double cosine(std::uint32_t face, const glm::dvec3& direction) const
    {
        const double length = glm::length(_areas[face]);
        return length > 0.0 ? glm::dot(_areas[face], direction) / length : 1.0;
    }

    /// Calls `join` for free faces around the seed, the nearest in direction first; the growth continues from
    /// accepted faces.
    template<class Join>
    void spread(std::uint32_t seed, const glm::dvec3& direction, const Join& join)
    {
        ++_visit;
        std::priority_queue<std::pair<double, std::uint32_t>> next;
        const auto add = [&](std::uint32_t face)
        {
            if (_visited[face] == _visit || charts.chartOfFace[face] != kNoChart) return;
            const double alike = cosine(face, direction);
            if (alike < _leastCosine) return;
            _visited[face] = _visit;
            next.emplace(alike, face);
        };
        add(seed);
        while (!next.empty())
        {
            const std::uint32_t face = next.top().second;
            next.pop();
            if (!join(face)) continue;
            for (HalfEdge side = 3 * face; side < 3 * face + 3; ++side)
                if (const std::uint32_t edge = _edges.edgeOf(side); edge != EdgeTable::kNone)
                    for (const HalfEdge other : _edges.sides(edge))
                        add(faceOf(other));
        }
    }

    void growFrom(std::uint32_t seed)
    {
        const double length = glm::length(_areas[seed]);
        const glm::dvec3 first = length > 0.0 ? _areas[seed] / length : glm::dvec3(0.0, 0.0, 1.0);
        glm::dvec3 sum(0.0);
        std::vector<std::uint32_t> around;
        spread(seed, first,
               [&](std::uint32_t face)
               {
                   sum += _areas[face];
                   around.push_back(face);
                   return true;
               });
        const double mean = glm::length(sum);
        // The seed must join, else the loop would not end.
        const glm::dvec3 direction =
            mean > 0.0 && cosine(seed, sum / mean) >= _leastCosine ? sum / mean : first;
        finish(seed, direction, around);
    }

    void finish(std::uint32_t seed, const glm::dvec3& direction, const std::vector<std::uint32_t>& around)
    {
        Chart chart;
        const glm::dvec3 size = glm::abs(direction);
        const glm::dvec3 aside = size.x <= size.y && size.x <= size.z ? glm::dvec3(1.0, 0.0, 0.0)
                                 : size.y <= size.z                   ? glm::dvec3(0.0, 1.0, 0.0)
                                                                      : glm::dvec3(0.0, 0.0, 1.0);
        chart.right = glm::normalize(glm::cross(aside, direction));
        chart.up = glm::cross(direction, chart.right);
        const auto flat = [&](std::uint32_t face)
        {
            const Triangle& t = _triangles[face];
            return FlatTriangle{chart.flat(at(t[0])), chart.flat(at(t[1])), chart.flat(at(t[2]))};
        };
        glm::dvec2 low(1e300), high(-1e300);
        for (const std::uint32_t face : around)
            for (const glm::dvec2& p : flat(face))
                low = glm::min(low, p), high = glm::max(high, p);
        FlatFaces taken(low, high, around.size());
        spread(seed, direction,
               [&](std::uint32_t face)
               {
                   if (!taken.add(flat(face)) && face != seed) return false;
                   chart.faces.push_back(face);
                   charts.chartOfFace[face] = static_cast<std::uint32_t>(charts.charts.size());
                   return true;
               });
        charts.charts.push_back(std::move(chart));
    }

    const Mesh& _mesh;
    std::vector<Triangle> _triangles;
    EdgeTable _edges;
    double _leastCosine;
    std::vector<glm::dvec3> _areas; ///< by face: its normal, of twice its area's length
    std::vector<std::uint32_t> _visited;
    std::uint32_t _visit = 0;
};

} // namespace

Charts makeCharts(const Mesh& mesh, const ChartSettings& settings)
{
    ChartGrowth growth(mesh, settings);
    growth.growAll();
    return std::move(growth.charts);
}

bool coversFacesOnce(const Charts& charts, std::size_t faceCount)
{
    if (charts.chartOfFace.size() != faceCount) return false;
    std::vector<bool> isCovered(faceCount, false);
    for (std::size_t c = 0; c < charts.charts.size(); ++c)
        for (const std::uint32_t face : charts.charts[c].faces)
        {
            if (face >= faceCount || isCovered[face] || charts.chartOfFace[face] != c) return false;
            isCovered[face] = true;
        }
    return std::all_of(isCovered.begin(), isCovered.end(), [](bool is) { return is; });
}

} // namespace osgPMObjects::core
