// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/drivers/FrameChange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <unordered_map>
#include <vector>

#include <osgTerrainROAM/core/roam/PlanTriangle.h>
#include <osgTerrainROAM/core/roam/TriangleSamples.h>
#include <osgTerrainROAM/core/roam/UpperSurface.h>

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

/// A triangle by its corners, in steps of the vertices, the least corner first: equal where it is drawn
/// alike.
using Corners = std::array<std::array<int, 3>, 3>;

struct PlacedTriangle
{
    Corners corners;
    LeafTriangle triangle;
};

std::vector<PlacedTriangle> sortedTriangles(const DrawnMesh& mesh)
{
    std::vector<PlacedTriangle> sorted;
    for (const LeafTriangle& t : mesh.triangles)
    {
        PlacedTriangle placed{{}, t};
        for (std::size_t i = 0; i < 3; ++i)
        {
            const glm::ivec3& p = mesh.vertices[t.vertices[i]].position;
            placed.corners[i] = {p.x, p.y, p.z};
        }
        std::rotate(placed.corners.begin(), std::min_element(placed.corners.begin(), placed.corners.end()),
                    placed.corners.end());
        sorted.push_back(placed);
    }
    std::sort(sorted.begin(), sorted.end(),
              [](const auto& a, const auto& b) { return a.corners < b.corners; });
    return sorted;
}

std::vector<PlacedTriangle> without(const std::vector<PlacedTriangle>& all,
                                    const std::vector<PlacedTriangle>& others)
{
    std::vector<PlacedTriangle> rest;
    std::set_difference(all.begin(), all.end(), others.begin(), others.end(), std::back_inserter(rest),
                        [](const auto& a, const auto& b) { return a.corners < b.corners; });
    return rest;
}

/// Calls visit(sample, place on the triangle) for each sample that it covers.
template<class Visit>
void forEachDrawn(const PlacedTile& tile, const DrawnMesh& mesh, const LeafTriangle& t, const Visit& visit)
{
    const auto& v = t.vertices;
    const PlanTriangle plan{{mesh.grid[v[0]], mesh.grid[v[1]], mesh.grid[v[2]]}};
    if (plan.doubleArea() <= 0) return;
    const glm::dvec3 a = mesh.position(v[0]), du = mesh.position(v[1]) - a, dw = mesh.position(v[2]) - a;
    forEachSampleIn(tile, plan,
                    [&](GridPoint p)
                    {
                        const auto b = plan.at(p.column, p.row);
                        visit(p, a + du * b.u + dw * b.w);
                    });
}

std::uint64_t keyOf(GridPoint p)
{
    return static_cast<std::uint64_t>(p.row) << 32 | static_cast<std::uint32_t>(p.column);
}

/// How far a change of height moves what is drawn at a place, in pixels of the middle of the picture.
double movedPx(const viewlod::ViewState& view, const glm::dvec3& place, double oldM)
{
    const double distanceM = std::max(glm::distance(place, view.eyeWorld), view.nearM);
    return view.pixelsPerTangent * std::abs(place.z - oldM) / distanceM;
}

/// The largest change of what is uppermost, over all samples: of meshes whose parts overlap.
double popOfUpper(const PlacedTile& tile, const DrawnMesh& before, const DrawnMesh& now,
                  const viewlod::ViewState& view)
{
    const UpperSurface was(tile, before), is(tile, now);
    double largestPx = 0.0;
    for (int row = 0; row < is.rows(); ++row)
        for (int column = 0; column < is.columns(); ++column)
            if (was.covers(column, row) && is.covers(column, row))
                largestPx =
                    std::max(largestPx, movedPx(view, is.point(column, row), was.point(column, row).z));
    return largestPx;
}

} // namespace

FrameChange changeBetween(const PlacedTile& tile, const DrawnMesh& before, const DrawnMesh& now,
                          const viewlod::ViewState& view)
{
    const auto was = sortedTriangles(before), is = sortedTriangles(now);
    const auto gone = without(was, is), come = without(is, was);
    if (now.overlaps()) return {come.size(), come.empty() ? 0.0 : popOfUpper(tile, before, now, view)};
    std::unordered_map<std::uint64_t, double> heightsM;
    for (const PlacedTriangle& t : gone)
        forEachDrawn(tile, before, t.triangle,
                     [&](GridPoint p, const glm::dvec3& place) { heightsM[keyOf(p)] = place.z; });
    FrameChange change{come.size(), 0.0};
    for (const PlacedTriangle& t : come)
        forEachDrawn(tile, now, t.triangle,
                     [&](GridPoint p, const glm::dvec3& place)
                     {
                         const auto old = heightsM.find(keyOf(p));
                         if (old == heightsM.end()) return;
                         change.popPx = std::max(change.popPx, movedPx(view, place, old->second));
                     });
    return change;
}

} // namespace terraintool
