// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <osgTerrainROAM/core/heightfield/FineSamples.h>
#include <osgTerrainROAM/core/heightfield/HeightField.h>
#include <osgTerrainROAM/core/heightfield/SampleMask.h>
#include <osgTerrainROAM/core/heightfield/SampleSheet.h>
#include <osgTerrainROAM/core/heightfield/SampleTable.h>
#include <osgTerrainROAM/core/heightfield/TileGrid.h>

namespace osgTerrainROAM::core
{

/// The samples of a tile: height, and error and radius of the bintree vertex (ErrorTree), by grid point.
/// Those of the raster lie in a table, those of denser parts in sheets over it, and those that edits have put
/// anywhere among the fine samples. A point without a sample lies on the surface of the samples around it and
/// has no error. Points beyond the data repeat the edge's height.
/// Threads: const from any, while nobody writes. Memory: SampleTable, SampleSheet, FineSamples, SampleMask.
class TileSamples
{
public:
    using Sample = SampleTable::Sample;

    /// Takes heights, mask and dense parts out of the field, and lays the parts over the raster.
    TileSamples(const TileGrid& grid, HeightField& field, Storage storage);

    const SampleTable& table() const { return _table; } ///< of the raster
    const SampleMask& mask() const { return _mask; }    ///< of the raster
    const std::vector<SampleSheet>& sheets() const { return _sheets; }
    const FineSamples& fineSamples() const { return _fine; }

    /// Height, error and radius at a point of the data. Without a sample there: the height of the surface,
    /// and zeros.
    Sample sample(int column, int row) const
    {
        Sample sample;
        if (_grid.isOfRaster(column, row) && _table.read(_grid.rasterIndex(column, row), sample)) [[likely]]
            return sample;
        return sampleBetween(column, row);
    }

    /// Height at a point, or at the nearest point of the data.
    float heightM(int column, int row) const
    {
        const int c = std::clamp(column, 0, _grid.dataColumns() - 1);
        const int r = std::clamp(row, 0, _grid.dataRows() - 1);
        if (_grid.isOfRaster(c, r)) [[likely]]
        {
            const std::size_t index = _grid.rasterIndex(c, r);
            if (!_table.isElsewhere(index)) [[likely]]
                return _table.heightM(index);
        }
        return sampleBetween(c, r).heightM;
    }

    /// Height of a raster sample as the raster's table has it, whatever edits have put in its stead.
    float rasterHeightM(int column, int row) const { return _table.heightM(_grid.rasterIndex(column, row)); }

    /// Fetches a point of the data into the processor's cache.
    void prefetch(int column, int row) const { _table.prefetch(_grid.rasterIndex(column, row)); }

    /// Tells whether the data have holes, or an outline that is not a rectangle.
    bool hasHoles() const { return !_mask.hasAll(); }

    /// Tells whether the ground reaches a point of the data: a sample that is there, or a point on one of the
    /// raster's finest triangles whose three corners are there.
    bool isGround(int column, int row) const
    {
        if (!hasHoles()) [[likely]]
            return true;
        return _grid.isOfRaster(column, row) ? isInMask(column, row) : isGroundBetween(column, row);
    }

    /// Counts the raster's samples that are there in a row, from `west` to `east`, both included.
    int samplesIn(int row, int west, int east) const
    {
        const int shift = _grid.exponent();
        return _mask.countIn(row >> shift, west >> shift, east >> shift);
    }

    /// Tells whether a sample of the raster or of a sheet belongs at a point.
    bool isMeasured(int column, int row) const
    {
        return _grid.isOfRaster(column, row) || sheetAt(column, row);
    }

    /// Tells whether an edit's sample is kept at a point.
    bool hasFineSample(int column, int row) const
    {
        const Sample* kept = _fine.find(column, row);
        return kept && FineSamples::hasHeight(*kept);
    }

    bool hasSample(int column, int row) const
    {
        return isMeasured(column, row) || hasFineSample(column, row);
    }

    /// Grid points from the sample at a point to the next: of the raster, or of a sheet; 1 for an edit's
    /// sample.
    int sampleStep(int column, int row) const
    {
        if (const SampleSheet* sheet = sheetAt(column, row)) return sheet->step();
        return _grid.isOfRaster(column, row) ? _grid.cellSide() : 1;
    }

    /// Calls visit(column, row) for every point of a rectangle within the data that has a sample, or counts
    /// among the samples (count). May visit a point twice.
    template<class Visit>
    void forEachSample(const GridRect& rect, const Visit& visit) const
    {
        const GridRect cut = rect.cutTo(_grid.dataRect());
        const auto visitGround = [&](int column, int row)
        {
            if (isGround(column, row)) visit(column, row);
        };
        cut.forEachMultipleOf(_grid.cellSide(), visitGround);
        for (const SampleSheet& sheet : _sheets)
            cut.cutTo(sheet.inside()).forEachMultipleOf(sheet.step(), visitGround);
        if (!_fine.isEmpty()) _fine.forEachIn(cut, visit);
    }

    /// Gives a sample of the raster, or of a sheet, another height: the surface between the samples follows.
    /// The height is kept exactly; where the table cannot, the surface follows to the table's nearest step.
    void setSampleHeight(int column, int row, float heightM);

    /// Puts a sample at a point of the data, or replaces the one there; the surface of the raster around it
    /// stays as it is.
    void setFineHeight(int column, int row, float heightM);

    /// Replaces a chunk of fine samples. Precondition: those of them at points of the raster are marked as
    /// elsewhere.
    void setFineChunk(int column, int row, const FineSamples::Chunk& samples)
    {
        _fine.setChunk(column, row, samples);
    }

    /// Counts a point among the samples, although its height goes on following the surface. Does nothing
    /// where a sample is.
    void count(int column, int row);

    /// All that is kept of a point of the data, for restore().
    struct Kept
    {
        Sample inTable{}, inSheet{}, inFine{};
        bool isInTable = false, isInSheet = false, isInFine = false, isElsewhere = false;
    };
    Kept kept(int column, int row) const;
    void restore(int column, int row, const Kept& kept);

    /// The least error or radius that a point can keep and that is not less.
    float roundedUpError(int column, int row, double errorM) const;
    float roundedUpRadius(int column, int row, double radiusM) const;

    /// Keeps an error and a radius that roundedUpError() and roundedUpRadius() gave.
    void setBound(int column, int row, float errorM, float radiusM);

    /// Chooses the radii that can be told apart, for a tile `diagonalM` from corner to corner.
    void setRadiusRange(double diagonalM);

private:
    bool isInMask(int column, int row) const
    {
        return _mask.holds(column >> _grid.exponent(), row >> _grid.exponent());
    }
    bool isInTable(int column, int row) const
    {
        return _grid.isOfRaster(column, row) && !_table.isElsewhere(_grid.rasterIndex(column, row));
    }
    bool isGroundBetween(int column, int row) const;
    Sample sampleBetween(int column, int row) const;
    /// Height of the raster with the first `sheets` of its sheets over it, without the fine samples.
    float surfaceM(int column, int row, std::size_t sheets) const;
    /// The finest sheet that holds a sample at a point; null: none.
    const SampleSheet* sheetAt(int column, int row) const;
    SampleSheet* sheetAt(int column, int row)
    {
        return const_cast<SampleSheet*>(std::as_const(*this).sheetAt(column, row));
    }
    const SampleTable* tableOf(int column, int row) const;
    void laySheets(std::vector<DensePart> parts, Storage storage);
    void fade(DensePart& part) const;

    TileGrid _grid;
    SampleTable _table;
    SampleMask _mask;
    std::vector<SampleSheet> _sheets; ///< coarse before fine
    FineSamples _fine;
};

} // namespace osgTerrainROAM::core
