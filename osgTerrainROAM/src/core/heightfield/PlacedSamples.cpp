// SPDX-License-Identifier: Apache-2.0
// The samples of a PlacedTile: those of the raster in a table, those between them, and those that the table cannot keep
// exactly, among the FineSamples.
#include <cmath>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "FloatNotLess.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kHeightToleranceM = 0.0005;

} // namespace

SampleTable::Sample PlacedTile::sampleBetween(int column, int row) const
{
    const SampleTable::Sample* kept = _fine.find(column, row);
    if (kept && FineSamples::hasHeight(*kept)) return *kept;
    if (const SampleSheet* sheet = sheetAt(column, row))
        return sheet->table().sample(sheet->index(column, row));
    const float heightM = surfaceM(column, row, _sheets.size());
    return kept ? SampleTable::Sample{heightM, kept->errorM, kept->radiusM}
                : SampleTable::Sample{heightM, 0.0f, 0.0f};
}

/// The corners of the finest triangle that count in a place; of two where it lies on an edge between samples.
bool PlacedTile::isGroundBetween(int column, int row) const
{
    const int step = 1 << _gridExponent;
    const int west = column & -step, south = row & -step;
    const int east = column - west, north = row - south; // in the cell
    const auto isThere = [&](int cellsEast, int cellsNorth)
    { return hasSampleOfRaster(west + cellsEast * step, south + cellsNorth * step); };
    if (north == 0) return isThere(0, 0) && isThere(1, 0);
    if (east == 0) return isThere(0, 0) && isThere(0, 1);
    const bool isEven = (((west >> _gridExponent) + (south >> _gridExponent)) & 1) == 0;
    if (isEven)
        return isThere(0, 0) && isThere(1, 1) && (east <= north || isThere(1, 0)) &&
               (east >= north || isThere(0, 1));
    return isThere(1, 0) && isThere(0, 1) && (east + north >= step || isThere(0, 0)) &&
           (east + north <= step || isThere(1, 1));
}

void PlacedTile::setSampleHeight(int column, int row, float heightM)
{
    const SampleTable::Sample before = sample(column, row);
    bool isExact = false;
    if (SampleSheet* sheet = sheetAt(column, row))
    {
        sheet->table().setHeight(sheet->index(column, row), heightM);
        isExact = std::abs(sheet->table().heightM(sheet->index(column, row)) - heightM) <= kHeightToleranceM;
        if (isOfRaster(column, row)) _samples.setHeight(rasterIndex(column, row), heightM);
    }
    else
    {
        const std::size_t index = rasterIndex(column, row);
        _samples.setHeight(index, heightM);
        isExact =
            std::abs(_samples.heightM(index) - heightM) <= kHeightToleranceM && !_samples.isElsewhere(index);
        if (!isExact) _samples.setElsewhere(index, true);
    }
    if (!isExact || _fine.find(column, row)) _fine.set(column, row, {heightM, before.errorM, before.radiusM});
}

void PlacedTile::setFineHeight(int column, int row, float heightM)
{
    const SampleTable::Sample before = sample(column, row);
    if (isOfRaster(column, row)) _samples.setElsewhere(rasterIndex(column, row), true);
    _fine.set(column, row, {heightM, before.errorM, before.radiusM});
}

void PlacedTile::count(int column, int row)
{
    if (hasSample(column, row)) return;
    const SampleTable::Sample before = sampleBetween(column, row);
    _fine.set(column, row, {FineSamples::kOnSurface, before.errorM, before.radiusM});
}

PlacedTile::Kept PlacedTile::kept(int column, int row) const
{
    Kept kept;
    if (isOfRaster(column, row))
    {
        const std::size_t index = rasterIndex(column, row);
        kept.isInTable = true;
        kept.isElsewhere = _samples.isElsewhere(index);
        kept.inTable = _samples.sample(index);
    }
    if (const SampleSheet* sheet = sheetAt(column, row))
    {
        kept.isInSheet = true;
        kept.inSheet = sheet->table().sample(sheet->index(column, row));
    }
    if (const SampleTable::Sample* fine = _fine.find(column, row))
    {
        kept.isInFine = true;
        kept.inFine = *fine;
    }
    return kept;
}

void PlacedTile::restore(int column, int row, const Kept& kept)
{
    if (kept.isInTable)
    {
        const std::size_t index = rasterIndex(column, row);
        _samples.setHeight(index, kept.inTable.heightM);
        _samples.setBound(index, kept.inTable.errorM, kept.inTable.radiusM);
        _samples.setElsewhere(index, kept.isElsewhere);
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

/// The table that a place's bounds are kept in; null: among the fine samples.
const SampleTable* PlacedTile::tableOf(int column, int row) const
{
    if (isInTable(column, row)) return &_samples;
    const SampleSheet* sheet = _fine.find(column, row) ? nullptr : sheetAt(column, row);
    return sheet ? &sheet->table() : nullptr;
}

float PlacedTile::roundedUpError(int column, int row, double errorM) const
{
    const SampleTable* table = tableOf(column, row);
    return table ? table->roundedUpError(errorM) : floatNotLess(errorM);
}

float PlacedTile::roundedUpRadius(int column, int row, double radiusM) const
{
    const SampleTable* table = tableOf(column, row);
    return table ? table->roundedUpRadius(radiusM) : floatNotLess(radiusM);
}

void PlacedTile::setBound(int column, int row, float errorM, float radiusM)
{
    if (isInTable(column, row)) return _samples.setBound(rasterIndex(column, row), errorM, radiusM);
    const SampleTable::Sample* before = _fine.find(column, row);
    if (SampleSheet* sheet = before ? nullptr : sheetAt(column, row))
        return sheet->table().setBound(sheet->index(column, row), errorM, radiusM);
    _fine.set(column, row, {before ? before->heightM : FineSamples::kNoHeight, errorM, radiusM});
}

} // namespace osgTerrainROAM::core
