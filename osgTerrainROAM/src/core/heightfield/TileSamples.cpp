// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include <osgTerrainROAM/core/heightfield/TileSamples.h>

#include "FloatNotLess.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kHeightToleranceM = 0.0005;

} // namespace

TileSamples::TileSamples(const TileGrid& grid, HeightField& field, Storage storage)
    : _grid(grid),
      _table(std::exchange(field.heightsM, {}), storage, grid.exponent() > 0 ? kEditHeadroom : 1.0),
      _mask(std::exchange(field.mask, {}))
{
    laySheets(std::exchange(field.parts, {}), storage);
}

void TileSamples::setRadiusRange(double diagonalM)
{
    double heightsM = _table.heightRangeM();
    for (const SampleSheet& sheet : _sheets)
        heightsM = std::max(heightsM, sheet.table().heightRangeM());
    const int points = _grid.side() - 1;
    const double mostM = 8.0 * (diagonalM + heightsM);
    _table.setRadiusRange(diagonalM / (points >> _grid.exponent()) / 16.0, mostM);
    for (SampleSheet& sheet : _sheets)
        sheet.table().setRadiusRange(diagonalM / points / 16.0, mostM);
}

TileSamples::Sample TileSamples::sampleBetween(int column, int row) const
{
    const Sample* kept = _fine.find(column, row);
    if (kept && FineSamples::hasHeight(*kept)) return *kept;
    if (const SampleSheet* sheet = sheetAt(column, row))
        return sheet->table().sample(sheet->index(column, row));
    const float heightM = surfaceM(column, row, _sheets.size());
    return kept ? Sample{heightM, kept->errorM, kept->radiusM} : Sample{heightM, 0.0f, 0.0f};
}

/// Looks at those corners of the raster's finest triangle whose height counts at a point: two, where it lies
/// on an edge.
bool TileSamples::isGroundBetween(int column, int row) const
{
    const int step = _grid.cellSide();
    const int west = column & -step, south = row & -step;
    const int east = column - west, north = row - south; // in the cell
    const auto isThere = [&](int cellsEast, int cellsNorth)
    { return isInMask(west + cellsEast * step, south + cellsNorth * step); };
    if (north == 0) return isThere(0, 0) && isThere(1, 0);
    if (east == 0) return isThere(0, 0) && isThere(0, 1);
    const bool isEven = (((west >> _grid.exponent()) + (south >> _grid.exponent())) & 1) == 0;
    if (isEven)
        return isThere(0, 0) && isThere(1, 1) && (east <= north || isThere(1, 0)) &&
               (east >= north || isThere(0, 1));
    return isThere(1, 0) && isThere(0, 1) && (east + north >= step || isThere(0, 0)) &&
           (east + north <= step || isThere(1, 1));
}

void TileSamples::setSampleHeight(int column, int row, float heightM)
{
    const Sample before = sample(column, row);
    bool isExact = false;
    if (SampleSheet* sheet = sheetAt(column, row))
    {
        sheet->table().setHeight(sheet->index(column, row), heightM);
        isExact = std::abs(sheet->table().heightM(sheet->index(column, row)) - heightM) <= kHeightToleranceM;
        if (_grid.isOfRaster(column, row)) _table.setHeight(_grid.rasterIndex(column, row), heightM);
    }
    else
    {
        const std::size_t index = _grid.rasterIndex(column, row);
        _table.setHeight(index, heightM);
        isExact =
            std::abs(_table.heightM(index) - heightM) <= kHeightToleranceM && !_table.isElsewhere(index);
        if (!isExact) _table.setElsewhere(index, true);
    }
    if (!isExact || _fine.find(column, row)) _fine.set(column, row, {heightM, before.errorM, before.radiusM});
}

void TileSamples::setFineHeight(int column, int row, float heightM)
{
    const Sample before = sample(column, row);
    if (_grid.isOfRaster(column, row)) _table.setElsewhere(_grid.rasterIndex(column, row), true);
    _fine.set(column, row, {heightM, before.errorM, before.radiusM});
}

void TileSamples::count(int column, int row)
{
    if (hasSample(column, row)) return;
    const Sample before = sampleBetween(column, row);
    _fine.set(column, row, {FineSamples::kOnSurface, before.errorM, before.radiusM});
}

TileSamples::Kept TileSamples::kept(int column, int row) const
{
    Kept kept;
    if (_grid.isOfRaster(column, row))
    {
        const std::size_t index = _grid.rasterIndex(column, row);
        kept.isInTable = true;
        kept.isElsewhere = _table.isElsewhere(index);
        kept.inTable = _table.sample(index);
    }
    if (const SampleSheet* sheet = sheetAt(column, row))
    {
        kept.isInSheet = true;
        kept.inSheet = sheet->table().sample(sheet->index(column, row));
    }
    if (const Sample* fine = _fine.find(column, row))
    {
        kept.isInFine = true;
        kept.inFine = *fine;
    }
    return kept;
}

void TileSamples::restore(int column, int row, const Kept& kept)
{
    if (kept.isInTable)
    {
        const std::size_t index = _grid.rasterIndex(column, row);
        _table.setHeight(index, kept.inTable.heightM);
        _table.setBound(index, kept.inTable.errorM, kept.inTable.radiusM);
        _table.setElsewhere(index, kept.isElsewhere);
    }
    if (kept.isInSheet)
    {
        SampleSheet& sheet = *sheetAt(column, row);
        const std::size_t index = sheet.index(column, row);
        sheet.table().setHeight(index, kept.inSheet.heightM);
        sheet.table().setBound(index, kept.inSheet.errorM, kept.inSheet.radiusM);
    }
    if (kept.isInFine)
        _fine.set(column, row, kept.inFine);
    else
        _fine.erase(column, row);
}

/// The table that keeps the bounds of a point; null: the fine samples do.
const SampleTable* TileSamples::tableOf(int column, int row) const
{
    if (isInTable(column, row)) return &_table;
    const SampleSheet* sheet = _fine.find(column, row) ? nullptr : sheetAt(column, row);
    return sheet ? &sheet->table() : nullptr;
}

float TileSamples::roundedUpError(int column, int row, double errorM) const
{
    const SampleTable* table = tableOf(column, row);
    return table ? table->roundedUpError(errorM) : floatNotLess(errorM);
}

float TileSamples::roundedUpRadius(int column, int row, double radiusM) const
{
    const SampleTable* table = tableOf(column, row);
    return table ? table->roundedUpRadius(radiusM) : floatNotLess(radiusM);
}

void TileSamples::setBound(int column, int row, float errorM, float radiusM)
{
    if (isInTable(column, row)) return _table.setBound(_grid.rasterIndex(column, row), errorM, radiusM);
    const Sample* before = _fine.find(column, row);
    if (SampleSheet* sheet = before ? nullptr : sheetAt(column, row))
        return sheet->table().setBound(sheet->index(column, row), errorM, radiusM);
    _fine.set(column, row, {before ? before->heightM : FineSamples::kNoHeight, errorM, radiusM});
}

} // namespace osgTerrainROAM::core
