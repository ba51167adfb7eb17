// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <osgTerrainROAM/core/features/FeatureCells.h>

#include "CellBuilder.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Result;

constexpr double kDefaultCellM = 64.0;
constexpr double kSmallestCellM = 32.0;
constexpr double kLargestCellM = 256.0;
constexpr double kCrowd = 24.0; ///< mean texels a cell above which smaller cells are faster

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

namespace
{

/// Paved ones that are lines of the map; an area is painted as it is.
std::vector<FeatureCells::Runway> straightRunways(const std::vector<RunwayFrame>& frames)
{
    std::vector<FeatureCells::Runway> runways;
    for (const RunwayFrame& frame : frames)
        if (frame.hasBed && frame.isPaved) runways.push_back({frame.a, frame.b, frame.widthM});
    return runways;
}

} // namespace

Result<FeatureCells> FeatureCells::build(const std::vector<GroundFeature>& features)
{
    FeatureCells cells;
    const FeatureShapes shapes(features);
    if (shapes.areas.empty() && shapes.segments.empty() && shapes.strokes.empty()) return cells;
    CellBuilder builder(cells, shapes);
    double cellM = kDefaultCellM;
    while (!builder.layGrid(cellM))
        if ((cellM *= 2.0) > kLargestCellM)
            return Error{"features", "reach over more than 4 million cells of 256 m",
                         "cut them to the terrain's extent with ogr2ogr -clipsrc"};
    builder.fill();
    if (cellM == kDefaultCellM && builder.crowd() > kCrowd && builder.layGrid(kSmallestCellM)) builder.fill();
    if (builder.records() > CellBuilder::kMostRecords)
        return Error{"features", "have more than 16 million edges in their cells",
                     "simplify them with ogr2ogr -simplify"};
    builder.store();
    cells.runways = straightRunways(shapes.runways);
    return cells;
}

foundation::ContentMark markOfCells(const FeatureCells& cells)
{
    foundation::ContentMark mark;
    mark.add(std::vector<double>{cells.cellM}).add(cells.cells).add(cells.records);
    for (const int number : {cells.firstCell.x, cells.firstCell.y, cells.columns, cells.rows})
        mark.addWord(static_cast<std::uint64_t>(number));
    return mark.add(cells.runways);
}

} // namespace osgTerrainROAM::core
