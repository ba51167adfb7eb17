// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgTerrainROAM/core/features/FeatureCells.h>

#include "FeatureShapes.h"

namespace osgTerrainROAM::core
{

namespace
{

using viewlod::Error;
using viewlod::Result;
using Texel = std::array<float, 4>;

constexpr std::size_t kMostCells = 1u << 22;
constexpr double kLongestGrid = 8192.0;        ///< cells a side: a texture's size
constexpr std::size_t kMostRecords = 1u << 24; ///< whole numbers that a float counts
constexpr double kUsualCellM = 64.0;
constexpr double kSmallestCellM = 32.0;
constexpr double kLargestCellM = 256.0;
constexpr double kCrowd = 24.0; ///< texels a cell, on average, from which smaller cells pay

Texel texel(double a, double b, double c, double d)
{
    return {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c), static_cast<float>(d)};
}

Texel texel(const glm::dvec2& a, const glm::dvec2& b)
{
    return texel(a.x, a.y, b.x, b.y);
}

/// One cell's list while it grows.
struct Draft
{
    std::uint32_t areas = 0, lines = 0, strokes = 0;
    std::vector<Texel> texels;
};

/// The whole cells within a box.
struct CellRange
{
    int firstColumn, lastColumn, firstRow, lastRow;
};

class Builder
{
public:
    Builder(FeatureCells& cells, const FeatureShapes& shapes) : _cells(cells), _shapes(shapes) {}

    bool layGrid(double cellM)
    {
        glm::dvec2 low(1e300), high(-1e300);
        const auto add = [&](const glm::dvec2& place, double halfWidthM)
        {
            low = glm::min(low, place - halfWidthM - FeatureCells::kReachM);
            high = glm::max(high, place + halfWidthM + FeatureCells::kReachM);
        };
        for (const auto& area : _shapes.areas)
            for (const Ring& ring : area.rings)
                for (const glm::dvec2& point : ring)
                    add(point, 0.0);
        for (const auto& [shapeA, shapeB, half] : ends())
        {
            add(shapeA, half);
            add(shapeB, half);
        }
        const glm::dvec2 first = glm::floor(low / cellM), last = glm::floor(high / cellM);
        const glm::dvec2 size = last - first + 1.0;
        if (!(size.x * size.y <= static_cast<double>(kMostCells)) || std::max(size.x, size.y) > kLongestGrid)
            return false;
        _cells.cellM = cellM;
        _cells.firstCell = glm::ivec2(first);
        _cells.columns = static_cast<int>(size.x);
        _cells.rows = static_cast<int>(size.y);
        return true;
    }

    void fill()
    {
        _drafts.assign(static_cast<std::size_t>(_cells.columns) * _cells.rows, {});
        for (const auto& area : _shapes.areas)
            addArea(area);
        for (const auto& segment : _shapes.segments)
            visit(segment.a, segment.b, segment.halfWidthM,
                  [&](Draft& draft, const glm::dvec2& middle)
                  {
                      ++draft.lines;
                      draft.texels.push_back(texel(segment.a - middle, segment.b - middle));
                      draft.texels.push_back(
                          texel(segment.halfWidthM, segment.wayM, segment.code, segment.line));
                  });
        for (const Stroke& stroke : _shapes.strokes)
            visit(stroke.a, stroke.b, stroke.halfWidthM,
                  [&](Draft& draft, const glm::dvec2& middle)
                  {
                      ++draft.strokes;
                      draft.texels.push_back(texel(stroke.a - middle, stroke.b - middle));
                      draft.texels.push_back(texel(stroke.halfWidthM, stroke.paint, 0.0, 0.0));
                  });
    }

    /// Texels a cell that has any.
    double crowd() const
    {
        std::size_t occupied = 0;
        for (const Draft& draft : _drafts)
            occupied += draft.texels.empty() ? 0 : 1;
        return static_cast<double>(records()) / static_cast<double>(std::max<std::size_t>(occupied, 1));
    }

    std::size_t records() const
    {
        std::size_t count = 0;
        for (const Draft& draft : _drafts)
            count += draft.texels.size();
        return count;
    }

    void store()
    {
        _cells.cells.clear();
        _cells.records.clear();
        for (const Draft& draft : _drafts)
        {
            _cells.cells.push_back(
                {static_cast<std::uint32_t>(_cells.records.size()), draft.areas, draft.lines, draft.strokes});
            _cells.records.insert(_cells.records.end(), draft.texels.begin(), draft.texels.end());
        }
    }

private:
    struct Ends
    {
        glm::dvec2 a, b;
        double halfWidthM;
    };

    std::vector<Ends> ends() const
    {
        std::vector<Ends> all;
        for (const auto& segment : _shapes.segments)
            all.push_back({segment.a, segment.b, segment.halfWidthM});
        for (const Stroke& stroke : _shapes.strokes)
            all.push_back({stroke.a, stroke.b, stroke.halfWidthM});
        return all;
    }

    CellRange cellsWithin(const glm::dvec2& low, const glm::dvec2& high) const
    {
        const auto index = [&](double place, int first, int count)
        { return std::clamp(static_cast<int>(std::floor(place / _cells.cellM)) - first, 0, count - 1); };
        return {index(low.x, _cells.firstCell.x, _cells.columns),
                index(high.x, _cells.firstCell.x, _cells.columns),
                index(low.y, _cells.firstCell.y, _cells.rows),
                index(high.y, _cells.firstCell.y, _cells.rows)};
    }

    glm::dvec2 middleOf(int column, int row) const
    {
        return (glm::dvec2(_cells.firstCell) + glm::dvec2(column, row) + 0.5) * _cells.cellM;
    }

    Draft& draft(int column, int row)
    {
        return _drafts[static_cast<std::size_t>(row) * _cells.columns + column];
    }

    /// Calls add(draft, middle) for each cell within reach of a stroke of the pen.
    template<class Add>
    void visit(const glm::dvec2& a, const glm::dvec2& b, double halfWidthM, const Add& add)
    {
        const double around = halfWidthM + FeatureCells::kReachM;
        const CellRange range = cellsWithin(glm::min(a, b) - around, glm::max(a, b) + around);
        for (int row = range.firstRow; row <= range.lastRow; ++row)
            for (int column = range.firstColumn; column <= range.lastColumn; ++column)
            {
                const glm::dvec2 middle = middleOf(column, row);
                const double half = 0.5 * _cells.cellM + around;
                if (segmentMeetsBox(a, b, middle - half, middle + half)) add(draft(column, row), middle);
            }
    }

    void addArea(const FeatureShapes::Area& area)
    {
        glm::dvec2 low(1e300), high(-1e300);
        for (const Ring& ring : area.rings)
            for (const glm::dvec2& point : ring)
            {
                low = glm::min(low, point);
                high = glm::max(high, point);
            }
        const double reach = FeatureCells::kReachM, half = 0.5 * _cells.cellM + reach;
        const CellRange range = cellsWithin(low - reach, high + reach);
        for (int row = range.firstRow; row <= range.lastRow; ++row)
        {
            const double north = middleOf(0, row).y;
            const std::vector<Ring> strip = clippedToBand(area.rings, 1, north - half, north + half);
            for (int column = range.firstColumn; column <= range.lastColumn && !strip.empty(); ++column)
            {
                const glm::dvec2 middle = middleOf(column, row);
                addEdges(draft(column, row), area, middle,
                         clippedToBand(strip, 0, middle.x - half, middle.x + half));
            }
        }
    }

    void addEdges(Draft& draft, const FeatureShapes::Area& area, const glm::dvec2& middle,
                  const std::vector<Ring>& rings) const
    {
        const double half = 0.5 * _cells.cellM + FeatureCells::kReachM;
        const std::size_t header = draft.texels.size();
        const glm::dvec2 across(-area.rows.y, area.rows.x);
        const double period = FeatureCells::kWayPeriodM;
        const double offset = glm::dot(middle, across);
        draft.texels.push_back({});
        const double way = glm::dot(middle, area.rows);
        draft.texels.push_back(texel(area.rows.x, area.rows.y, offset - period * std::floor(offset / period),
                                     way - period * std::floor(way / period)));
        for (const Ring& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
            {
                const glm::dvec2 a = ring[i] - middle, b = ring[(i + 1) % ring.size()] - middle;
                // Along the western, northern and southern border: no ray from the cell to the east meets them, and
                // they are no edges of the feature.
                const bool west = a.x <= -half && b.x <= -half;
                const bool level = a.y == b.y && std::abs(a.y) >= half;
                if (!west && !level) draft.texels.push_back(texel(a, b));
            }
        const std::size_t edges = draft.texels.size() - header - 2;
        draft.texels[header] = texel(static_cast<double>(edges), static_cast<int>(area.kind),
                                     static_cast<int>(area.crop), area.seed);
        if (edges == 0)
            draft.texels.resize(header);
        else
            ++draft.areas;
    }

    FeatureCells& _cells;
    const FeatureShapes& _shapes;
    std::vector<Draft> _drafts;
};

} // namespace

const FeatureCells::Cell* FeatureCells::cellAt(const glm::dvec2& place) const
{
    const glm::ivec2 index = glm::ivec2(glm::floor(place / cellM)) - firstCell;
    if (index.x < 0 || index.y < 0 || index.x >= columns || index.y >= rows) return nullptr;
    return &cells[static_cast<std::size_t>(index.y) * columns + index.x];
}

glm::dvec2 FeatureCells::inCell(const glm::dvec2& place) const
{
    return place - (glm::floor(place / cellM) + 0.5) * cellM;
}

bool FeatureCells::isConsistent() const
{
    if (cells.size() != static_cast<std::size_t>(columns) * rows) return false;
    for (const Cell& cell : cells)
    {
        std::size_t at = cell.first;
        for (std::uint32_t i = 0; i < cell.areas; ++i)
        {
            if (at >= records.size() || !(records[at][0] >= 1.0f)) return false;
            at += 2 + static_cast<std::size_t>(records[at][0]);
        }
        if (at + 2 * (static_cast<std::size_t>(cell.lines) + cell.strokes) > records.size()) return false;
    }
    return true;
}

Result<FeatureCells> FeatureCells::build(const std::vector<GroundFeature>& features)
{
    FeatureCells cells;
    const FeatureShapes shapes(features);
    if (shapes.areas.empty() && shapes.segments.empty() && shapes.strokes.empty()) return cells;
    Builder builder(cells, shapes);
    double cellM = kUsualCellM;
    while (!builder.layGrid(cellM))
        if ((cellM *= 2.0) > kLargestCellM)
            return Error{"features", "reach over more than 4 million cells of 256 m",
                         "cut them to the terrain's extent with ogr2ogr -clipsrc"};
    builder.fill();
    if (cellM == kUsualCellM && builder.crowd() > kCrowd && builder.layGrid(kSmallestCellM)) builder.fill();
    if (builder.records() > kMostRecords)
        return Error{"features", "have more than 16 million edges in their cells",
                     "simplify them with ogr2ogr -simplify"};
    builder.store();
    return cells;
}

} // namespace osgTerrainROAM::core
