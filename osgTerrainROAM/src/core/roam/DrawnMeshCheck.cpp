// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <unordered_set>
#include <vector>

#include <viewlod/ScreenError.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/Outline.h>
#include <osgTerrainROAM/core/roam/PlanTriangle.h>
#include <osgTerrainROAM/core/roam/TriangleSamples.h>
#include <osgTerrainROAM/core/roam/UpperSurface.h>

#include "../heightfield/NearestSample.h"
#include "BareEdges.h"
#include "MovedTriangle.h"
#include "OpenEdges.h"

namespace osgTerrainROAM::core
{

namespace
{

/// The distance between a sample and the point that is drawn for it; 0 outside the frame.
double errorPx(const viewlod::ViewState& view, const glm::dvec3& sample, const glm::dvec3& drawn)
{
    const auto wanted = viewlod::projectPx(view, sample);
    if (!wanted || wanted->x < 0 || wanted->y < 0 || wanted->x > view.widthPx || wanted->y > view.heightPx)
        return 0.0;
    const auto shown = viewlod::projectPx(view, drawn);
    return shown ? glm::distance(*wanted, *shown) : std::numeric_limits<double>::infinity();
}

/// Compares samples and surface, triangle by triangle.
class SampleSweep
{
public:
    SampleSweep(const RoamTile& tile, const viewlod::ViewState* view) : _tile(tile), _view(view)
    {
        const PlacedTile& placed = tile.tile;
        _covered.assign(rasterIndex({placed.grid().dataColumns() - 1, placed.grid().dataRows() - 1}) + 1,
                        false);
        placed.samples().fineSamples().forEachIn({0, 0, placed.grid().side(), placed.grid().side()},
                                                 [this](int column, int row) {
                                                     _uncovered.insert(key({column, row}));
                                                 });
        for (const SampleSheet& sheet : placed.samples().sheets())
            _sheetsCovered.emplace_back(sheet.table().size(), false);
        if (view) _reliefM = reliefOf(placed);
        if (!placed.samples().hasHoles()) return;
        for (int row = 0; row < placed.grid().dataRows(); row += step())
            for (int column = 0; column < placed.grid().dataColumns(); column += step())
                if (!placed.samples().isGround(column, row)) cover({column, row});
    }

    void visit(const DrawnMesh& mesh, const LeafTriangle& t)
    {
        const PlacedTile& placed = _tile.tile;
        if (mesh.isMorphed)
            if (const auto moved = movedSideways(mesh, t)) return visit(mesh, t, *moved);
        const auto corner = [&](int i) { return mesh.grid[t.vertices[i]]; };
        const PlanTriangle triangle{{corner(0), corner(1), corner(2)}};
        if (triangle.doubleArea() <= 0)
        {
            ++_turnedOver;
            return;
        }
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
        if (placed.samples().hasHoles()) noteHoles(triangle);
    }

    /// Counts samples beside holes that lie in leaves that are not drawn: the outline is off there.
    std::size_t uncovered()
    {
        if (_tile.tile.samples().hasHoles()) compareOutline();
        return _turnedOver + std::count(_covered.begin(), _covered.end(), false) + _uncovered.size() +
               uncoveredOfSheets();
    }
    double maxErrorPx() const { return _maxErrorPx; }

private:
    static std::uint64_t key(GridPoint p)
    {
        return static_cast<std::uint64_t>(p.row) << 32 | static_cast<std::uint64_t>(p.column);
    }

    /// Where the corners of a triangle are drawn on the grid, if any of them is not above or below its
    /// sample.
    std::optional<MovedTriangle> movedSideways(const DrawnMesh& mesh, const LeafTriangle& t) const
    {
        constexpr double kAside = 0.01; // of a point of the grid; less is the Earth's curvature
        MovedTriangle moved;
        bool isMoved = false;
        for (std::size_t i = 0; i < 3; ++i)
        {
            const GridPoint own = mesh.grid[t.vertices[i]];
            const glm::dvec2 there(own.column, own.row);
            moved.corners[i] = _tile.tile.frame().gridAt(mesh.position(t.vertices[i]));
            if (glm::distance(moved.corners[i], there) > kAside)
                isMoved = true;
            else
                moved.corners[i] = there;
        }
        return isMoved ? std::optional(moved) : std::nullopt;
    }

    /// Compares the samples that a triangle covers with the places of its corners as they are drawn. One
    /// without extent covers none: a vertex has just begun to move.
    void visit(const DrawnMesh& mesh, const LeafTriangle& t, const MovedTriangle& moved)
    {
        const PlacedTile& placed = _tile.tile;
        if (moved.isTurnedOver()) ++_turnedOver;
        if (moved.doubleArea() <= MovedTriangle::kRounding) return;
        const glm::dvec3 a = mesh.position(t.vertices[0]), du = mesh.position(t.vertices[1]) - a,
                         dw = mesh.position(t.vertices[2]) - a;
        moved.forEachSample(placed,
                            [&](int column, int row, double u, double w)
                            {
                                cover({column, row});
                                if (_view) compare(placed.position(column, row), a + du * u + dw * w);
                            });
    }

    std::size_t uncoveredOfSheets() const
    {
        if (_tile.tile.samples().hasHoles()) return 0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < _sheetsCovered.size(); ++i)
        {
            const SampleSheet& sheet = _tile.tile.samples().sheets()[i];
            sheet.inside().forEachMultipleOf(sheet.step(), [&](int column, int row)
                                             { count += !_sheetsCovered[i][sheet.index(column, row)]; });
        }
        return count;
    }

    int step() const { return _tile.tile.grid().cellSide(); }

    /// Counts missing samples that are drawn.
    void noteHoles(const PlanTriangle& t)
    {
        const PlacedTile& placed = _tile.tile;
        t.forEachRow(
            placed.grid().dataColumns(), placed.grid().dataRows(),
            [&](int row, int west, int east)
            {
                if (placed.samples().samplesIn(row, west, east) == (east - west) / step() + 1) return;
                for (int column = west; column <= east; column += step())
                    if (!placed.samples().isGround(column, row)) _misplaced.push_back({column, row});
            },
            step());
    }

    /// Measures the distance of missing samples that are drawn, and of present ones that are not, from the
    /// nearest of the other kind.
    void compareOutline()
    {
        const PlacedTile& placed = _tile.tile;
        const int columns = placed.field().columns, rows = placed.field().rows,
                  shift = placed.grid().exponent();
        std::vector<std::uint8_t> isThere(_covered.size());
        for (std::size_t i = 0; i < isThere.size(); ++i)
        {
            const GridPoint p{static_cast<int>(i % static_cast<std::size_t>(columns)) << shift,
                              static_cast<int>(i / static_cast<std::size_t>(columns)) << shift};
            isThere[i] = placed.samples().isGround(p.column, p.row);
            if (!_covered[i] && isCornerOfGround(placed, p)) _misplaced.push_back(p);
            _covered[i] = true;
        }
        if (!_view || _misplaced.empty()) return;
        const NearestSample ground(isThere, columns, rows);
        for (std::uint8_t& there : isThere)
            there = !there;
        const NearestSample hole(isThere, columns, rows);
        for (const GridPoint& p : _misplaced)
        {
            const std::size_t other = (placed.samples().isGround(p.column, p.row) ? hole : ground)
                                          .nearest(p.column >> shift, p.row >> shift);
            const int column = static_cast<int>(other % static_cast<std::size_t>(columns)) << shift;
            const int row = static_cast<int>(other / static_cast<std::size_t>(columns)) << shift;
            compare(placed.position(p.column, p.row), placed.position(column, row));
        }
    }

    std::size_t rasterIndex(GridPoint p) const
    {
        const int shift = _tile.tile.grid().exponent();
        const int columns = ((_tile.tile.grid().dataColumns() - 1) >> shift) + 1;
        return static_cast<std::size_t>(p.row >> shift) * columns +
               static_cast<std::size_t>(p.column >> shift);
    }

    void cover(GridPoint p)
    {
        if (((p.column | p.row) & (_tile.tile.grid().cellSide() - 1)) == 0) _covered[rasterIndex(p)] = true;
        if (!_uncovered.empty()) _uncovered.erase(key(p));
        const auto& sheets = _tile.tile.samples().sheets();
        for (std::size_t i = 0; i < sheets.size(); ++i)
            if (sheets[i].holds(p.column, p.row)) _sheetsCovered[i][sheets[i].index(p.column, p.row)] = true;
    }

    /// Tests a sphere around the triangle thickened by its error: whether any of its samples can be visible.
    /// A triangle that is none of the bintree may be off by all of the relief.
    bool mayBeSeen(const PlanTriangle& plan, const glm::dvec3& a, const glm::dvec3& du,
                   const glm::dvec3& dw) const
    {
        const GridTriangle t{plan.corners[0], plan.corners[1], plan.corners[2]};
        if (!isOfBintree(t))
        {
            constexpr double kTurned = 1.1; // on the round Earth heights are not along the frame's third axis
            const glm::dvec3 middle = a + (du + dw) / 3.0;
            const double farthest = std::max(
                {glm::distance(middle, a), glm::distance(middle, a + du), glm::distance(middle, a + dw)});
            return !_view->frustum.classify(middle, farthest + kTurned * _reliefM).outside;
        }
        const GridPoint mid = middle(t.left, t.right);
        const bool finest = (t.left.column + t.right.column) % 2 != 0 || (t.left.row + t.right.row) % 2 != 0;
        const double error = finest ? 0.0 : _tile.bound(mid).errorM;
        const glm::dvec3 centre = a + (du + dw) * 0.5;
        const double radius = std::max(glm::length(du - dw) * 0.5, glm::distance(centre, a)) + error;
        return !_view->frustum.classify(centre, radius).outside;
    }

    /// Whether it has the shape of a triangle of the bintree, at the place of one.
    static bool isOfBintree(const GridTriangle& t)
    {
        const int lc = t.left.column - t.apex.column, lr = t.left.row - t.apex.row;
        const int rc = t.right.column - t.apex.column, rr = t.right.row - t.apex.row;
        const bool isAlongAxes = lc == 0 || lr == 0;
        const int size = std::max(std::abs(lc), std::abs(lr));
        if (rc != -lr || rr != lc || (!isAlongAxes && std::abs(lc) != std::abs(lr))) return false;
        if ((size & (size - 1)) != 0 || t.apex.column % size != 0 || t.apex.row % size != 0) return false;
        const bool isOddColumn = t.apex.column / size % 2 != 0, isOddRow = t.apex.row / size % 2 != 0;
        return isAlongAxes ? isOddColumn != isOddRow : isOddColumn && isOddRow;
    }

    void compare(const glm::dvec3& sample, const glm::dvec3& drawn)
    {
        _maxErrorPx = std::max(_maxErrorPx, errorPx(*_view, sample, drawn));
    }

    /// From the lowest sample to the highest, along the frame's third axis; infinite where samples lie
    /// between those of the raster.
    static double reliefOf(const PlacedTile& tile)
    {
        if (tile.grid().exponent() > 0) return std::numeric_limits<double>::infinity();
        double lowM = std::numeric_limits<double>::infinity(), highM = -lowM;
        for (int row = 0; row < tile.grid().dataRows(); ++row)
            for (int column = 0; column < tile.grid().dataColumns(); ++column)
            {
                if (!tile.samples().isGround(column, row)) continue;
                const double z = tile.position(column, row).z;
                lowM = std::min(lowM, z);
                highM = std::max(highM, z);
            }
        return highM - lowM;
    }

    const RoamTile& _tile;
    const viewlod::ViewState* _view;
    double _reliefM = 0.0;
    std::vector<bool> _covered; ///< samples of the raster
    std::vector<std::vector<bool>> _sheetsCovered;
    std::unordered_set<std::uint64_t> _uncovered; ///< those between
    std::vector<GridPoint> _misplaced;            ///< samples by which the outline is off
    std::size_t _turnedOver = 0;                  ///< triangles without extent, or turned over in plan
    double _maxErrorPx = 0.0;
};

/// Whether a vertex is drawn where its sample lies, but for rounding, or below it if it hangs under other
/// parts.
bool isInPlace(const PlacedTile& tile, const DrawnMesh& mesh, std::uint32_t vertex)
{
    const GridPoint p = mesh.grid[vertex];
    const glm::dvec3 off = mesh.position(vertex) - tile.position(p.column, p.row);
    if (mesh.overlaps() && mesh.sunk[vertex])
        return glm::length(glm::dvec2(off)) <= mesh.stepM && off.z < 0.0;
    return glm::length(off) <= mesh.stepM; // rounding: half a step on each axis
}

/// Counts as cracks the samples under no triangle, and compares what is uppermost.
void compareUppermost(const RoamTile& tile, const DrawnMesh& mesh, const viewlod::ViewState* view,
                      DrawnMeshReport& report)
{
    const PlacedTile& placed = tile.tile;
    const UpperSurface surface(placed, mesh);
    const int shift = placed.grid().exponent();
    for (int row = 0; row < surface.rows(); ++row)
        for (int column = 0; column < surface.columns(); ++column)
            if (!surface.covers(column, row))
                ++report.cracks;
            else if (view)
                report.maxErrorPx =
                    std::max(report.maxErrorPx, errorPx(*view, placed.position(column << shift, row << shift),
                                                        surface.point(column, row)));
}

/// Compares samples and surface only.
DrawnMeshReport sweep(const RoamTile& tile, const DrawnMesh& mesh, const viewlod::ViewState* view)
{
    DrawnMeshReport report;
    if (mesh.overlaps())
    {
        compareUppermost(tile, mesh, view, report);
        return report;
    }
    SampleSweep samples(tile, view);
    for (const LeafTriangle& t : mesh.triangles)
        samples.visit(mesh, t);
    report.cracks = samples.uncovered();
    report.maxErrorPx = samples.maxErrorPx();
    return report;
}

/// Whether a triangle has no extent in plan, or is turned over.
bool isFlat(const DrawnMesh& mesh, const LeafTriangle& t)
{
    return PlanTriangle{{mesh.grid[t.vertices[0]], mesh.grid[t.vertices[1]], mesh.grid[t.vertices[2]]}}
               .doubleArea() <= 0;
}

} // namespace

DrawnMeshReport checkDrawnMesh(const RoamTile& tile, const DrawnMesh& mesh, const viewlod::ViewState* view)
{
    DrawnMeshReport report = sweep(tile, mesh, view);
    report.tJunctions = mesh.overlaps() ? bareEdges(tile.tile, mesh) : tJunctions(tile.tile, mesh);
    for (const LeafTriangle& t : mesh.triangles)
    {
        report.cracks += mesh.overlaps() && isFlat(mesh, t) ? 1 : 0; // the sweep counts those of others
        for (const std::uint32_t v : t.vertices)
            if (!mesh.isMorphed && !isInPlace(tile.tile, mesh, v)) ++report.cracks;
    }
    return report;
}

double drawnErrorPx(const RoamTile& tile, const DrawnMesh& mesh, const viewlod::ViewState& view)
{
    return sweep(tile, mesh, &view).maxErrorPx;
}

} // namespace osgTerrainROAM::core
