// SPDX-License-Identifier: Apache-2.0
#include "CellBuilder.h"

#include <algorithm>
#include <cmath>

namespace osgTerrainROAM::core
{

namespace
{

constexpr std::size_t kMostCells = 1u << 22;
constexpr double kLongestGrid = 8192.0; ///< cells a side: a texture's size

std::array<float, 4> texel(double a, double b, double c, double d)
{
    return {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c), static_cast<float>(d)};
}

std::array<float, 4> texel(const glm::dvec2& a, const glm::dvec2& b)
{
    return texel(a.x, a.y, b.x, b.y);
}

/// The west-east extent of the part of a segment between two northings; empty when there is none.
glm::dvec2 eastsBetween(const glm::dvec2& a, const glm::dvec2& b, double south, double north)
{
    double enters = 0.0, leaves = 1.0;
    if (const double rise = b.y - a.y; rise != 0.0)
    {
        const double atSouth = (south - a.y) / rise, atNorth = (north - a.y) / rise;
        enters = std::max(enters, std::min(atSouth, atNorth));
        leaves = std::min(leaves, std::max(atSouth, atNorth));
    }
    else if (a.y < south || a.y > north)
        return {1e300, -1e300};
    if (enters > leaves) return {1e300, -1e300};
    const double first = a.x + enters * (b.x - a.x), last = a.x + leaves * (b.x - a.x);
    return {std::min(first, last), std::max(first, last)};
}

} // namespace

bool CellBuilder::layGrid(double cellM)
{
    glm::dvec2 low(1e300), high(-1e300);
    const auto add = [&](const glm::dvec2& place, double halfWidthM)
    {
        low = glm::min(low, place - halfWidthM - FeatureCells::kLampReachM);
        high = glm::max(high, place + halfWidthM + FeatureCells::kLampReachM);
    };
    for (const auto& area : _shapes.areas)
        for (const Ring& ring : area.rings)
            for (const glm::dvec2& point : ring)
                add(point, 0.0);
    for (const auto& segment : _shapes.segments)
        for (const glm::dvec2& end : {segment.a, segment.b})
            add(end, segment.halfWidthM);
    for (const Stroke& stroke : _shapes.strokes)
        for (const glm::dvec2& end : {stroke.a, stroke.b})
            add(end, stroke.halfWidthM);
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

/// Calls add(draft, middle) for each cell that comes within `around` metres of a segment, row by row.
template<class Add>
void CellBuilder::visit(const glm::dvec2& a, const glm::dvec2& b, double around, const Add& add)
{
    const double half = 0.5 * _cells.cellM + around;
    const Range rows = rangeOf(std::min(a.y, b.y) - around, std::max(a.y, b.y) + around, 1);
    for (int row = rows.first; row <= rows.last && _records <= kMostRecords; ++row)
    {
        const double middleNorth = middleOf(0, row).y;
        const glm::dvec2 easts = eastsBetween(a, b, middleNorth - half, middleNorth + half);
        if (easts.x > easts.y) continue;
        const Range columns = rangeOf(easts.x - around, easts.y + around, 0);
        for (int column = columns.first; column <= columns.last; ++column)
            add(draft(column, row), middleOf(column, row));
        _records += 2 * static_cast<std::size_t>(columns.last - columns.first + 1);
    }
}

void CellBuilder::fill()
{
    _records = 0;
    _drafts.assign(static_cast<std::size_t>(_cells.columns) * _cells.rows, {});
    for (const auto& area : _shapes.areas)
        addArea(area);
    for (const auto& segment : _shapes.segments)
        visit(segment.a, segment.b, segment.halfWidthM + FeatureCells::kReachM,
              [&](Draft& draft, const glm::dvec2& middle)
              {
                  ++draft.lines;
                  draft.texels.push_back(texel(segment.a - middle, segment.b - middle));
                  draft.texels.push_back(texel(segment.halfWidthM, segment.wayM, segment.code, segment.line));
              });
    for (const Stroke& stroke : _shapes.strokes)
    {
        const double reach =
            stroke.paint == FeatureCells::edgeLight ? FeatureCells::kLampReachM : FeatureCells::kReachM;
        visit(stroke.a, stroke.b, stroke.halfWidthM + reach,
              [&](Draft& draft, const glm::dvec2& middle)
              {
                  ++draft.strokes;
                  draft.texels.push_back(texel(stroke.a - middle, stroke.b - middle));
                  draft.texels.push_back(texel(stroke.halfWidthM, stroke.paint, 0.0, 0.0));
              });
    }
}

double CellBuilder::crowd() const
{
    std::size_t occupied = 0;
    for (const Draft& draft : _drafts)
        occupied += draft.texels.empty() ? 0 : 1;
    return static_cast<double>(records()) / static_cast<double>(std::max<std::size_t>(occupied, 1));
}

void CellBuilder::store()
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

CellBuilder::Range CellBuilder::rangeOf(double low, double high, int axis) const
{
    const int first = _cells.firstCell[axis], count = axis == 0 ? _cells.columns : _cells.rows;
    const auto index = [&](double place)
    { return std::clamp(static_cast<int>(std::floor(place / _cells.cellM)) - first, 0, count - 1); };
    return {index(low), index(high)};
}

glm::dvec2 CellBuilder::middleOf(int column, int row) const
{
    return (glm::dvec2(_cells.firstCell) + glm::dvec2(column, row) + 0.5) * _cells.cellM;
}

void CellBuilder::addArea(const FeatureShapes::Area& area)
{
    glm::dvec2 low(1e300), high(-1e300);
    for (const Ring& ring : area.rings)
        for (const glm::dvec2& point : ring)
        {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
    const double reach = FeatureCells::kReachM, half = 0.5 * _cells.cellM + reach;
    const Range columns = rangeOf(low.x - reach, high.x + reach, 0),
                rows = rangeOf(low.y - reach, high.y + reach, 1);
    for (int row = rows.first; row <= rows.last && _records <= kMostRecords; ++row)
    {
        const double north = middleOf(0, row).y;
        const std::vector<Ring> strip = clippedToBand(area.rings, 1, north - half, north + half);
        for (int column = columns.first; column <= columns.last && !strip.empty(); ++column)
        {
            const glm::dvec2 middle = middleOf(column, row);
            addEdges(draft(column, row), area, middle,
                     clippedToBand(strip, 0, middle.x - half, middle.x + half));
        }
    }
}

void CellBuilder::addEdges(Draft& draft, const FeatureShapes::Area& area, const glm::dvec2& middle,
                           const std::vector<Ring>& rings)
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
            // Edges along the western, northern and southern border are left out: they come from clipping,
            // and no ray from the cell to the east meets them.
            const bool west = a.x <= -half && b.x <= -half;
            const bool level = a.y == b.y && std::abs(a.y) >= half;
            if (!west && !level) draft.texels.push_back(texel(a, b));
        }
    const std::size_t edges = draft.texels.size() - header - 2;
    draft.texels[header] = texel(static_cast<double>(edges), static_cast<int>(area.kind),
                                 static_cast<int>(area.crop), area.seed);
    draft.areas += edges > 0 ? 1 : 0;
    if (edges == 0) draft.texels.resize(header);
    _records += draft.texels.size() - header;
}

} // namespace osgTerrainROAM::core
