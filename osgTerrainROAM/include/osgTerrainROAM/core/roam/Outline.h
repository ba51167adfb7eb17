// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

/// Whether a triangle of the bintree is drawn when it is a leaf: more of it than its border lies in the data, and the ground
/// reaches those of its corners that do. On the finest level that is the outline of the data, and of their holes.
inline bool isDrawn(const PlacedTile& tile, const GridTriangle& t)
{
    if (!t.overlaps(tile.grid().dataColumns(), tile.grid().dataRows())) return false;
    if (!tile.samples().hasHoles()) [[likely]]
        return true;
    const auto isMissing = [&](GridPoint p)
    { return tile.grid().isInData(p.column, p.row) && !tile.samples().isGround(p.column, p.row); };
    return !isMissing(t.apex) && !isMissing(t.left) && !isMissing(t.right);
}

/// How far the outline may be misplaced by drawing a triangle, or by leaving it out: its diameter, if it holds both samples that
/// are there and such that are not, and 0 otherwise. The error of the vertex that splits it is no less, so that an outline, too, is
/// within the tolerance. Units: metres.
double outlineErrorM(const PlacedTile& tile, const GridTriangle& t);

/// Whether a sample that is there is a corner of what is drawn on the finest level of the raster.
bool isCornerOfGround(const PlacedTile& tile, GridPoint sample);

} // namespace osgTerrainROAM::core
