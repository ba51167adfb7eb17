// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

/// Whether a triangle of the bintree is drawn when it is a leaf: more of it than its border lies in the data,
/// and those of its corners that are in the data have a sample. On the finest level this gives the outline of
/// the data and of their holes.
inline bool isDrawn(const PlacedTile& tile, const GridTriangle& t)
{
    if (!t.overlaps(tile.grid().dataColumns(), tile.grid().dataRows())) return false;
    if (!tile.samples().hasHoles()) [[likely]]
        return true;
    const auto isMissing = [&](GridPoint p)
    { return tile.grid().isInData(p.column, p.row) && !tile.samples().isGround(p.column, p.row); };
    return !isMissing(t.apex) && !isMissing(t.left) && !isMissing(t.right);
}

/// The distance by which drawing a triangle, or leaving it out, may misplace the outline: its diameter if it
/// holds both present and missing samples, otherwise 0. The error of the vertex that splits it is no less, so
/// the outline is within the tolerance, too. Units: metres.
double outlineErrorM(const PlacedTile& tile, const GridTriangle& t);

/// Whether a present sample is a corner of a drawn triangle on the finest level of the raster.
bool isCornerOfGround(const PlacedTile& tile, GridPoint sample);

} // namespace osgTerrainROAM::core
