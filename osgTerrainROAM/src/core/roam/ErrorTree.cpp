// SPDX-License-Identifier: Apache-2.0
// Exact error bounds of a triangle bintree: every data sample is compared with the plane of every triangle
// that holds it, then errors and radii are nested over the diamonds.
// Source: Lindstrom & Pascucci, *Visualization of large terrains made easy*, 2001 (nesting). Differs: they
// take the error of a triangle from its split vertex alone, which does not bound the error of the samples
// between.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include <foundation/Threads.h>

#include <osgTerrainROAM/core/heightfield/SampleRaster.h>
#include <osgTerrainROAM/core/roam/ErrorTree.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>
#include <osgTerrainROAM/core/roam/Outline.h>

#include "BottomUp.h"
#include "RowDistance.h"

namespace osgTerrainROAM::core
{

namespace
{

/// The positions of the samples, each computed once: triangles and diamonds ask for each some ten times.
class SamplePositions
{
public:
    explicit SamplePositions(const SampleRaster& tile) : _tile(tile), _columns(tile.dataColumns())
    {
        const SampleMask& mask = tile.tile().samples().mask();
        _positions.resize(static_cast<std::size_t>(_columns) * tile.dataRows());
        for (int row = 0; row < tile.dataRows(); ++row)
            for (int column = 0; column < _columns; ++column)
                _positions[static_cast<std::size_t>(row) * _columns + column] =
                    mask.holds(column, row) ? tile.position(column, row) : kNoSample;
    }

    /// The first column's position in a row of the data, and behind it the others'; kNoSample where there is
    /// none.
    const glm::dvec3* row(int row) const { return &_positions[static_cast<std::size_t>(row) * _columns]; }

    /// The position of any point of the padded raster.
    glm::dvec3 at(GridPoint p) const
    {
        if (p.column < _columns && p.row < _tile.dataRows())
            if (const glm::dvec3& known = row(p.row)[p.column]; !std::isnan(known.x)) [[likely]]
                return known;
        return _tile.position(p.column, p.row);
    }

private:
    SampleRaster _tile;
    int _columns;
    std::vector<glm::dvec3> _positions;
};

/// Rasterises the triangles of the bintree over the samples.
class TriangleErrors
{
public:
    TriangleErrors(const SampleRaster& tile, const SamplePositions& positions, std::vector<float>& errors)
        : _tile(tile),
          _side(tile.side()),
          _columns(tile.dataColumns()),
          _positions(positions),
          _errors(errors)
    {
    }

    /// Errors of the triangle (apex, left, right) and everything below it, depth first: the samples of the
    /// small triangles are still in the cache when the larger ones read them again. Two threads may measure
    /// the two roots: they meet only at split vertices on the shared base, where the larger error wins in any
    /// order.
    void measure(const GridTriangle& t, int level)
    {
        if (level == _tile.levels() || outsideData(t)) return;
        for (const GridTriangle& child : t.children())
            measure(child, level + 1);
        raise(middle(t.left, t.right),
              std::max(std::sqrt(largestSquaredError(t)), outlineErrorM(_tile.tile(), onGrid(t))));
    }

private:
    GridTriangle onGrid(const GridTriangle& t) const
    {
        const int shift = _tile.tile().grid().exponent();
        const auto place = [shift](GridPoint p) { return GridPoint{p.column << shift, p.row << shift}; };
        return {place(t.apex), place(t.left), place(t.right)};
    }

    bool outsideData(const GridTriangle& t) const
    {
        return std::min({t.apex.column, t.left.column, t.right.column}) >= _columns ||
               std::min({t.apex.row, t.left.row, t.right.row}) >= _tile.dataRows();
    }

    void raise(GridPoint v, double error)
    {
        std::atomic_ref<float> stored(_errors[static_cast<std::size_t>(v.row) * _side + v.column]);
        const float wanted = _tile.table().roundedUpError(error);
        float seen = stored.load(std::memory_order_relaxed);
        while (seen < wanted && !stored.compare_exchange_weak(seen, wanted, std::memory_order_relaxed))
        {
        }
    }

    double largestSquaredError(const GridTriangle& t) const
    {
        const glm::dvec3 origin = _positions.at(t.apex), du = _positions.at(t.left) - origin,
                         dw = _positions.at(t.right) - origin;
        const auto east = t.perColumn(), north = t.perRow();
        const glm::dvec3 perColumn = du * east.u + dw * east.w, perRow = du * north.u + dw * north.w;
        double largest = 0.0;
        t.forEachRow(_columns, _tile.dataRows(),
                     [&](int row, int west, int eastmost)
                     {
                         const glm::dvec3 start = origin + perRow * static_cast<double>(row - t.apex.row);
                         largest = largestSquared(largest, _positions.row(row) + west, eastmost - west + 1,
                                                  start, perColumn, west - t.apex.column);
                     });
        return largest;
    }

    SampleRaster _tile;
    const int _side;
    const int _columns;
    const SamplePositions& _positions;
    std::vector<float>& _errors;
};

std::size_t indexOf(const SampleRaster& tile, GridPoint p)
{
    return static_cast<std::size_t>(p.row) * tile.side() + p.column;
}

/// X_v as the predicate sees it.
glm::dvec3 centreOf(const SampleRaster& tile, GridPoint p)
{
    return glm::vec3(tile.position(p.column, p.row));
}

} // namespace

ErrorTree::ErrorTree(const PlacedTile& placed)
{
    const SampleRaster tile(placed);
    _errorsM.assign(static_cast<std::size_t>(tile.side()) * tile.side(), 0.0f);
    _radiiM.assign(_errorsM.size(), 0.0f);
    const SamplePositions positions(tile);
    {
        TriangleErrors triangles(tile, positions, _errorsM);
        const auto roots = rootTriangles(tile.side());
        foundation::Threads other;
        other.run([&] { triangles.measure(roots[0], 0); });
        triangles.measure(roots[1], 0);
        other.join();
    }
    forEachDiamondBottomUp(tile.side(),
                           [&](GridPoint v, const GridPoint* children, int count)
                           {
                               const std::size_t index = indexOf(tile, v);
                               const glm::dvec3 place = positions.at(v), centre = glm::vec3(place);
                               double radius = glm::distance(centre, place);
                               for (int i = 0; i < count; ++i)
                               {
                                   const std::size_t child = indexOf(tile, children[i]);
                                   _errorsM[index] = std::max(_errorsM[index], _errorsM[child]);
                                   const glm::dvec3 below = glm::vec3(positions.at(children[i]));
                                   radius = std::max(radius, glm::distance(centre, below) + _radiiM[child]);
                               }
                               _radiiM[index] = tile.table().roundedUpRadius(radius * kRadiusSlack);
                           });
}

bool ErrorTree::isNested(const PlacedTile& placed) const
{
    const SampleRaster tile(placed);
    bool nested = true;
    forEachDiamondBottomUp(
        tile.side(),
        [&](GridPoint v, const GridPoint* children, int count)
        {
            const std::size_t index = indexOf(tile, v);
            for (int i = 0; i < count; ++i)
            {
                const std::size_t child = indexOf(tile, children[i]);
                const double reach =
                    glm::distance(centreOf(tile, v), centreOf(tile, children[i])) + _radiiM[child];
                nested = nested && _errorsM[index] >= _errorsM[child] && _radiiM[index] >= reach;
            }
        });
    return nested;
}

} // namespace osgTerrainROAM::core
