// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include <viewlod/ScreenError.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/TriangleSamples.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Directed edges as sorted keys: an edge is sound when its reverse is there, too.
std::size_t unsharedEdges(const PlacedTile& tile, const DrawnMesh& mesh)
{
    using Edge = std::pair<std::uint64_t, std::uint64_t>;
    const auto index = [&](std::uint32_t v)
    { return static_cast<std::uint64_t>(mesh.grid[v].row) * tile.side() + mesh.grid[v].column; };
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const LeafTriangle& t : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            edges.emplace_back(index(t.vertices[i]), index(t.vertices[(i + 1) % 3]));
    std::sort(edges.begin(), edges.end());

    const auto atDataBorder = [&](std::uint64_t a, std::uint64_t b)
    {
        const std::uint64_t side = tile.side();
        const std::uint64_t lastColumn = tile.dataColumns() - 1, lastRow = tile.dataRows() - 1;
        const auto both = [&](auto holds) { return holds(a) && holds(b); };
        return both([&](std::uint64_t p) { return p % side == 0; }) ||
               both([&](std::uint64_t p) { return p / side == 0; }) ||
               both([&](std::uint64_t p) { return p % side >= lastColumn; }) ||
               both([&](std::uint64_t p) { return p / side >= lastRow; });
    };
    std::size_t unshared = 0;
    for (const auto& [from, to] : edges)
        if (!std::binary_search(edges.begin(), edges.end(), Edge{to, from}) && !atDataBorder(from, to))
            ++unshared;
    return unshared;
}

/// Compares samples and surface, triangle by triangle.
class SampleSweep
{
public:
    SampleSweep(const RoamTile& tile, const viewlod::ViewState* view) : _tile(tile), _view(view)
    {
        const PlacedTile& placed = tile.tile;
        _covered.assign(rasterIndex({placed.dataColumns() - 1, placed.dataRows() - 1}) + 1, false);
        placed.fineSamples().forEachIn({0, 0, placed.side(), placed.side()},
                                       [this](int column, int row) {
                                           _uncovered.insert(key({column, row}));
                                       });
    }

    void visit(const DrawnMesh& mesh, const LeafTriangle& t)
    {
        const PlacedTile& placed = _tile.tile;
        const auto corner = [&](int i) { return mesh.grid[t.vertices[i]]; };
        const GridTriangle triangle{corner(0), corner(1), corner(2)};
        const glm::dvec3 a = mesh.position(t.vertices[0]), du = mesh.position(t.vertices[1]) - a,
                         dw = mesh.position(t.vertices[2]) - a;
        const bool projected = _view && mayBeSeen(triangle, a, du, dw);
        forEachSampleIn(placed, triangle,
                        [&](GridPoint p)
                        {
                            cover(p);
                            if (!projected) return;
                            const auto b = triangle.at(p.column, p.row);
                            compare(placed.position(p.column, p.row), a + du * b.u + dw * b.w);
                        });
    }

    std::size_t uncovered() const
    {
        return std::count(_covered.begin(), _covered.end(), false) + _uncovered.size();
    }
    double maxErrorPx() const { return _maxErrorPx; }

private:
    static std::uint64_t key(GridPoint p)
    {
        return static_cast<std::uint64_t>(p.row) << 32 | static_cast<std::uint64_t>(p.column);
    }

    std::size_t rasterIndex(GridPoint p) const
    {
        const int shift = _tile.tile.gridExponent();
        const int columns = ((_tile.tile.dataColumns() - 1) >> shift) + 1;
        return static_cast<std::size_t>(p.row >> shift) * columns +
               static_cast<std::size_t>(p.column >> shift);
    }

    void cover(GridPoint p)
    {
        if (((p.column | p.row) & ((1 << _tile.tile.gridExponent()) - 1)) == 0)
            _covered[rasterIndex(p)] = true;
        if (!_uncovered.empty()) _uncovered.erase(key(p));
    }

    /// The samples of a triangle lie within its error of it, so a sphere around both tells whether any can be seen.
    bool mayBeSeen(const GridTriangle& t, const glm::dvec3& a, const glm::dvec3& du,
                   const glm::dvec3& dw) const
    {
        const GridPoint mid = middle(t.left, t.right);
        const bool finest = (t.left.column + t.right.column) % 2 != 0 || (t.left.row + t.right.row) % 2 != 0;
        const double error = finest ? 0.0 : _tile.bound(mid).errorM;
        const glm::dvec3 centre = a + (du + dw) * 0.5;
        const double radius = std::max(glm::length(du - dw) * 0.5, glm::distance(centre, a)) + error;
        return !_view->frustum.classify(centre, radius).outside;
    }

    void compare(const glm::dvec3& sample, const glm::dvec3& drawn)
    {
        const auto wanted = viewlod::projectPx(*_view, sample);
        if (!wanted || wanted->x < 0 || wanted->y < 0 || wanted->x > _view->widthPx ||
            wanted->y > _view->heightPx)
            return;
        const auto shown = viewlod::projectPx(*_view, drawn);
        const double error = shown ? glm::distance(*wanted, *shown) : std::numeric_limits<double>::infinity();
        _maxErrorPx = std::max(_maxErrorPx, error);
    }

    const RoamTile& _tile;
    const viewlod::ViewState* _view;
    std::vector<bool> _covered;                   ///< samples of the raster
    std::unordered_set<std::uint64_t> _uncovered; ///< those between
    double _maxErrorPx = 0.0;
};

} // namespace

DrawnMeshReport checkDrawnMesh(const RoamTile& tile, const DrawnMesh& mesh, const viewlod::ViewState* view)
{
    DrawnMeshReport report;
    report.tJunctions = unsharedEdges(tile.tile, mesh);
    SampleSweep sweep(tile, view);
    for (const LeafTriangle& t : mesh.triangles)
    {
        for (const std::uint32_t v : t.vertices)
        {
            const GridPoint p = mesh.grid[v];
            const double offM = glm::distance(mesh.position(v), tile.tile.position(p.column, p.row));
            if (!mesh.isMorphed && offM > mesh.stepM) ++report.cracks; // rounding: half a step on each axis
        }
        sweep.visit(mesh, t);
    }
    report.cracks += sweep.uncovered();
    report.maxErrorPx = sweep.maxErrorPx();
    return report;
}

} // namespace osgTerrainROAM::core
