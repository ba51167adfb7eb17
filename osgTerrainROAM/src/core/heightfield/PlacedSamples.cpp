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
    if (!kept) return {interpolatedHeightM(column, row), 0.0f, 0.0f};
    if (FineSamples::hasHeight(*kept)) return *kept;
    return {interpolatedHeightM(column, row), kept->errorM, kept->radiusM};
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

/// On the triangle of the raster's own finest level, whose diagonals join samples with an even column + row; of the
/// raster as it is without fine samples.
float PlacedTile::interpolatedHeightM(int column, int row) const
{
    const int step = 1 << _gridExponent;
    const int west = std::min(column & -step, _dataColumns - 1 - step);
    const int south = std::min(row & -step, _dataRows - 1 - step);
    const double east = static_cast<double>(column - west) / step,
                 north = static_cast<double>(row - south) / step;
    const auto height = [this](int c, int r) -> double { return _samples.heightM(rasterIndex(c, r)); };
    const double sw = height(west, south), se = height(west + step, south), nw = height(west, south + step),
                 ne = height(west + step, south + step);
    const bool isEven = (((west >> _gridExponent) + (south >> _gridExponent)) & 1) == 0;
    double heightM = 0.0;
    if (isEven)
        heightM = east >= north ? sw + east * (se - sw) + north * (ne - se)
                                : sw + north * (nw - sw) + east * (ne - nw);
    else if (east + north <= 1.0)
        heightM = sw + east * (se - sw) + north * (nw - sw);
    else
        heightM = ne + (1.0 - east) * (nw - ne) + (1.0 - north) * (se - ne);
    return static_cast<float>(heightM);
}

void PlacedTile::setRasterHeight(int column, int row, float heightM)
{
    const std::size_t index = rasterIndex(column, row);
    const SampleTable::Sample before = sample(column, row);
    _samples.setHeight(index, heightM);
    const bool isExact = std::abs(_samples.heightM(index) - heightM) <= kHeightToleranceM;
    if (!isExact || _samples.isElsewhere(index))
    {
        _samples.setElsewhere(index, true);
        _fine.set(column, row, {heightM, before.errorM, before.radiusM});
    }
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
    if (kept.isInFine)
        _fine.set(column, row, kept.inFine);
    else
        _fine.erase(column, row);
}

float PlacedTile::roundedUpError(int column, int row, double errorM) const
{
    return isInTable(column, row) ? _samples.roundedUpError(errorM) : floatNotLess(errorM);
}

float PlacedTile::roundedUpRadius(int column, int row, double radiusM) const
{
    return isInTable(column, row) ? _samples.roundedUpRadius(radiusM) : floatNotLess(radiusM);
}

void PlacedTile::setBound(int column, int row, float errorM, float radiusM)
{
    if (isInTable(column, row)) return _samples.setBound(rasterIndex(column, row), errorM, radiusM);
    const SampleTable::Sample* before = _fine.find(column, row);
    _fine.set(column, row, {before ? before->heightM : FineSamples::kNoHeight, errorM, radiusM});
}

} // namespace osgTerrainROAM::core
