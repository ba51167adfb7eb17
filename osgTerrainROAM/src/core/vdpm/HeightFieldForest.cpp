// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <osgMultiTriangulation/core/build/CollapseOrder.h>
#include <osgMultiTriangulation/core/surface/GridSurface.h>
#include <osgTerrainROAM/core/roam/PlanTriangle.h>
#include <osgTerrainROAM/core/vdpm/BuildForest.h>
#include <osgTerrainROAM/core/vdpm/HeightFieldForest.h>

#include "SplitBall.h"

namespace osgTerrainROAM::core
{

namespace
{

/// Measures the triangles of each collapse over all samples in them.
class SampleMeter : public CollapseWitness
{
public:
    explicit SampleMeter(const PlacedTile& tile) : _columns(tile.field().columns), _rows(tile.field().rows)
    {
        const int shift = tile.grid().exponent();
        _positions.reserve(static_cast<std::size_t>(_columns) * _rows);
        for (int row = 0; row < _rows; ++row)
            for (int column = 0; column < _columns; ++column)
                _positions.push_back(tile.position(column << shift, row << shift));
    }

    /// Collapses that were left out before may let a later one turn a face over in plan.
    bool collapse(const CollapsedStar& star) override
    {
        for (const Triangle& t : star.floorCorners)
            if (PlanTriangle{{pointOf(t[0]), pointOf(t[1]), pointOf(t[2])}}.doubleArea() <= 0) return false;
        double error = 0.0;
        for (const Triangle& t : star.floorCorners)
            error = std::max(error, errorOf(t));
        for (const Triangle& t : star.corners)
            for (const std::uint32_t v : t)
                error = std::max(error, errorOfSwept(star.v0, star.v1, v));
        _bounds.push_back(ballAround(star.corners, _positions, error));
        return true;
    }

    const std::vector<glm::dvec3>& positions() const { return _positions; }

    /// By split.
    std::vector<SplitBound> bounds() const { return {_bounds.rbegin(), _bounds.rend()}; }

private:
    GridPoint pointOf(std::uint32_t sample) const
    {
        return {static_cast<int>(sample % static_cast<std::uint32_t>(_columns)),
                static_cast<int>(sample / static_cast<std::uint32_t>(_columns))};
    }

    /// The same for the triangle that the side from v0 to a neighbour sweeps while v0 moves to v1.
    double errorOfSwept(std::uint32_t v0, std::uint32_t v1, std::uint32_t neighbour) const
    {
        const PlanTriangle plan{{pointOf(v0), pointOf(v1), pointOf(neighbour)}};
        const std::int64_t area = plan.doubleArea();
        if (area == 0) return 0.0;
        return errorOf(area > 0 ? Triangle{v0, v1, neighbour} : Triangle{v1, v0, neighbour});
    }

    /// The largest distance of a sample in a triangle from the point of the triangle at its place in the
    /// plan.
    double errorOf(const Triangle& t) const
    {
        const PlanTriangle plan{{pointOf(t[0]), pointOf(t[1]), pointOf(t[2])}};
        const glm::dvec3 a = _positions[t[0]], ab = _positions[t[1]] - a, ac = _positions[t[2]] - a;
        double largest = 0.0; // its square
        plan.forEachRow(_columns, _rows,
                        [&](int row, int west, int east)
                        {
                            const GridTriangle::Barycentric first = plan.at(west, row),
                                                            second = plan.at(west + 1, row);
                            const glm::dvec3 start = a + ab * first.u + ac * first.w;
                            const glm::dvec3 step = ab * (second.u - first.u) + ac * (second.w - first.w);
                            const glm::dvec3* samples =
                                &_positions[static_cast<std::size_t>(row) * _columns + west];
                            for (int i = 0; i <= east - west; ++i)
                            {
                                const glm::dvec3 off = samples[i] - (start + step * static_cast<double>(i));
                                largest = std::max(largest, glm::dot(off, off));
                            }
                        });
        return std::sqrt(largest);
    }

    int _columns, _rows;
    std::vector<glm::dvec3> _positions; ///< by raster index
    std::vector<SplitBound> _bounds;    ///< by collapse
};

foundation::Error unusable(const PlacedTile& tile, const char* what)
{
    return {tile.field().name, std::string("a progressive mesh cannot be made of ") + what,
            "use the method roam"};
}

} // namespace

foundation::Result<BoundedForest> heightFieldForest(const PlacedTile& tile)
{
    const TileSamples& samples = tile.samples();
    if (samples.hasHoles()) return unusable(tile, "a raster with holes");
    if (!samples.sheets().empty()) return unusable(tile, "a raster with denser parts");
    if (!samples.fineSamples().isEmpty()) return unusable(tile, "an edited raster");
    const int columns = tile.field().columns, rows = tile.field().rows, shift = tile.grid().exponent();
    std::vector<float> heights;
    heights.reserve(static_cast<std::size_t>(columns) * rows);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            heights.push_back(samples.heightM(column << shift, row << shift));
    const auto surface = osgMultiTriangulation::core::gridSurface(columns, rows, heights);
    std::vector<EdgeCollapse> collapses;
    collapses.reserve(heights.size());
    for (const auto& c : osgMultiTriangulation::core::collapseOrder(surface))
        collapses.push_back({c.vertex, c.into});
    SampleMeter meter(tile);
    VertexForest forest =
        buildForest(surface.triangles, static_cast<std::uint32_t>(heights.size()), collapses, &meter);
    std::vector<glm::dvec3> positions;
    positions.reserve(forest.original.size());
    for (const std::uint32_t sample : forest.original)
        positions.push_back(meter.positions()[sample]);
    return nestBounds(std::move(forest), std::move(positions), meter.bounds());
}

} // namespace osgTerrainROAM::core
