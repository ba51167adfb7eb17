// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/HeightField.h>
#include <osgTerrainROAM/core/heightfield/TileFrame.h>
#include <osgTerrainROAM/core/heightfield/TileGrid.h>
#include <osgTerrainROAM/core/heightfield/TileSamples.h>

namespace osgTerrainROAM::core
{

/// What a tile is made with besides its height field.
struct PlacedTileOptions
{
    Placement placement = Placement::curved; ///< a field without georeference is always planar
    Storage storage = Storage::compact;
    std::optional<Geodetic> origin =
        std::nullopt;     ///< of the frame; absent: the data's centre at ellipsoidal height 0
    int gridExponent = 0; ///< the grid has at least 2^gridExponent points from one sample to the next
};

/// A height field as a square tile: a grid of points (TileGrid), samples at some of them (TileSamples), and a
/// frame that gives each point a 3D position (TileFrame). Points beyond the data exist only so that the
/// bintree is complete: they count in no error and are clipped when drawn.
/// Threads: const from any, while nobody writes samples.
class PlacedTile
{
public:
    explicit PlacedTile(HeightField field, const PlacedTileOptions& options);
    explicit PlacedTile(HeightField field, Placement placement = Placement::curved,
                        Storage storage = Storage::compact)
        : PlacedTile(std::move(field), PlacedTileOptions{placement, storage, std::nullopt, 0})
    {
    }
    PlacedTile(HeightField field, const Geodetic& origin)
        : PlacedTile(std::move(field), PlacedTileOptions{.origin = origin})
    {
    }

    const TileGrid& grid() const { return _grid; }
    const TileFrame& frame() const { return _frame; }
    const TileSamples& samples() const { return _samples; }
    TileSamples& samples() { return _samples; }

    /// The field's name, size, spacings, georeference and reports. Its heights, mask and dense parts are in
    /// samples().
    const HeightField& field() const { return _field; }

    /// Adds lines to the field's notes that are not there.
    void addNotes(const std::vector<std::string>& lines)
    {
        for (const std::string& line : lines)
            if (std::find(_field.notes.begin(), _field.notes.end(), line) == _field.notes.end())
                _field.notes.push_back(line);
    }

    /// Position of a grid point, 0 ≤ column, row < side. Cost: TileFrame::positionOf.
    glm::dvec3 position(int column, int row) const
    {
        return _frame.positionOf(column, row, _samples.heightM(column, row));
    }

    /// Position of a raster sample as the raster's table has it (TileSamples::rasterHeightM).
    glm::dvec3 rasterPosition(int column, int row) const
    {
        return _frame.positionOf(column, row, _samples.rasterHeightM(column, row));
    }

private:
    HeightField _field;
    TileGrid _grid;
    TileSamples _samples;
    TileFrame _frame;
};

} // namespace osgTerrainROAM::core
