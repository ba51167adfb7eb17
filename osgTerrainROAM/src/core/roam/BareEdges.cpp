// SPDX-License-Identifier: Apache-2.0
#include "BareEdges.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <osgTerrainROAM/core/roam/PlanTriangle.h>

#include "EdgesWithoutTwin.h"

namespace osgTerrainROAM::core
{

namespace
{

/// Edges of one part of the mesh that no other triangle of that part has, but for those at the edge of the
/// data.
std::vector<SlotEdge> endsOfParts(const PlacedTile& tile, const DrawnMesh& mesh)
{
    std::vector<std::uint32_t> slots(mesh.grid.size());
    std::iota(slots.begin(), slots.end(), 0u);
    std::vector<SlotEdge> ends = edgesWithoutTwin(mesh.triangles, slots);
    const int east = tile.grid().dataColumns() - 1, north = tile.grid().dataRows() - 1;
    std::erase_if(ends,
                  [&](const SlotEdge& edge)
                  {
                      const GridPoint a = mesh.grid[edge.first], b = mesh.grid[edge.second];
                      return (a.column == b.column && (a.column == 0 || a.column >= east)) ||
                             (a.row == b.row && (a.row == 0 || a.row >= north));
                  });
    return ends;
}

/// Triangles by the squares of the grid that they touch.
class TrianglesBySquare
{
public:
    TrianglesBySquare(const PlacedTile& tile, const DrawnMesh& mesh)
        : _columns(tile.grid().dataColumns() / kSide + 1), _rows(tile.grid().dataRows() / kSide + 1)
    {
        _squares.resize(static_cast<std::size_t>(_columns) * static_cast<std::size_t>(_rows));
        _extents.reserve(mesh.triangles.size());
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        {
            const auto& v = mesh.triangles[i].vertices;
            _extents.push_back(PlanTriangle{{mesh.grid[v[0]], mesh.grid[v[1]], mesh.grid[v[2]]}}.extent());
            forEachSquare(_extents[i],
                          [&](GridRect, std::vector<std::uint32_t>& square) { square.push_back(i); });
        }
    }

    /// Calls visit(triangle) once for each triangle whose extent touches a rectangle.
    void forEachNear(const GridRect& around, const auto& visit)
    {
        forEachSquare(around,
                      [&](GridRect square, std::vector<std::uint32_t>& triangles)
                      {
                          for (const std::uint32_t i : triangles)
                          {
                              // In more than one square, both extents have their lowest common point in one
                              // of them.
                              const GridRect common = _extents[i].cutTo(around);
                              if (!common.isEmpty() && common.west / kSide == square.west &&
                                  common.south / kSide == square.south)
                                  visit(i);
                          }
                      });
    }

private:
    static constexpr int kSide = 16;

    /// Calls visit(square's column and row, its triangles).
    void forEachSquare(const GridRect& rect, const auto& visit)
    {
        const int east = std::min(rect.east / kSide, _columns - 1),
                  north = std::min(rect.north / kSide, _rows - 1);
        for (int row = rect.south / kSide; row <= north; ++row)
            for (int column = rect.west / kSide; column <= east; ++column)
                visit(GridRect{column, row, column, row},
                      _squares[static_cast<std::size_t>(row * _columns + column)]);
    }

    int _columns, _rows;
    std::vector<std::vector<std::uint32_t>> _squares;
    std::vector<GridRect> _extents; ///< by triangle
};

using Interval = std::pair<double, double>;

/// Keeps the part of an interval where a linear function, with these values at 0 and 1, is at least 0.
void cutTo(Interval& part, double at0, double at1)
{
    const double slope = at1 - at0;
    if (slope == 0.0)
    {
        if (at0 < 0.0) part.second = -1.0;
        return;
    }
    if (slope > 0.0)
        part.first = std::max(part.first, -at0 / slope);
    else
        part.second = std::min(part.second, -at0 / slope);
}

/// The part of an edge, from 0 at its beginning to 1 at its end, over which a triangle lies above it; second
/// < first: none.
Interval coveredBy(const DrawnMesh& mesh, const LeafTriangle& t, const SlotEdge& edge)
{
    constexpr double kRounding = 1e-12; // the edge may run along a side of the triangle
    Interval part{0.0, 1.0};
    const PlanTriangle plan{{mesh.grid[t.vertices[0]], mesh.grid[t.vertices[1]], mesh.grid[t.vertices[2]]}};
    if (plan.doubleArea() <= 0) return {1.0, 0.0};
    const double z[3] = {mesh.position(t.vertices[0]).z, mesh.position(t.vertices[1]).z,
                         mesh.position(t.vertices[2]).z};
    double weights[2][3], above[2];
    for (int end = 0; end < 2; ++end)
    {
        const std::uint32_t vertex = end == 0 ? edge.first : edge.second;
        const auto b = plan.at(mesh.grid[vertex].column, mesh.grid[vertex].row);
        weights[end][0] = 1.0 - b.u - b.w;
        weights[end][1] = b.u;
        weights[end][2] = b.w;
        above[end] = weights[end][0] * z[0] + weights[end][1] * z[1] + weights[end][2] * z[2] -
                     mesh.position(vertex).z - mesh.stepM;
    }
    for (int corner = 0; corner < 3; ++corner)
        cutTo(part, weights[0][corner] + kRounding, weights[1][corner] + kRounding);
    cutTo(part, above[0], above[1]);
    return part;
}

/// Whether intervals leave nothing of 0 to 1.
bool coverAll(std::vector<Interval> parts)
{
    constexpr double kRounding = 1e-9;
    std::sort(parts.begin(), parts.end());
    double reached = 0.0;
    for (const auto& [first, last] : parts)
    {
        if (first > reached + kRounding) return false;
        reached = std::max(reached, last);
    }
    return reached >= 1.0 - kRounding;
}

} // namespace

std::size_t bareEdges(const PlacedTile& tile, const DrawnMesh& mesh)
{
    TrianglesBySquare squares(tile, mesh);
    std::size_t bare = 0;
    for (const SlotEdge& edge : endsOfParts(tile, mesh))
    {
        const GridPoint a = mesh.grid[edge.first], b = mesh.grid[edge.second];
        std::vector<Interval> parts;
        const GridRect around{std::min(a.column, b.column), std::min(a.row, b.row),
                              std::max(a.column, b.column), std::max(a.row, b.row)};
        squares.forEachNear(around,
                            [&](std::uint32_t i)
                            {
                                const Interval part = coveredBy(mesh, mesh.triangles[i], edge);
                                if (part.first <= part.second) parts.push_back(part);
                            });
        bare += coverAll(std::move(parts)) ? 0 : 1;
    }
    return bare;
}

} // namespace osgTerrainROAM::core
