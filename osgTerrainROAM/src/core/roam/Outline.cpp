// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgTerrainROAM/core/roam/Outline.h>

namespace osgTerrainROAM::core
{

double outlineErrorM(const PlacedTile& tile, const GridTriangle& t)
{
    if (!tile.samples().hasHoles()) return 0.0;
    const int step = tile.grid().cellSide();
    const GridRect extent = t.extent();
    if (extent.east - extent.west <= step && extent.north - extent.south <= step)
        return 0.0; // in one finest triangle
    std::int64_t samples = 0, places = 0;
    t.forEachRow(
        tile.grid().dataColumns(), tile.grid().dataRows(),
        [&](int row, int west, int east)
        {
            samples += tile.samples().samplesIn(row, west, east);
            places += (east - west) / step + 1;
        },
        step);
    const bool isAsItShould = isDrawn(tile, t) ? samples == places : samples == 0;
    if (isAsItShould) return 0.0;
    const auto position = [&](GridPoint p) { return tile.position(p.column, p.row); };
    const glm::dvec3 apex = position(t.apex), left = position(t.left), right = position(t.right);
    return std::max({glm::distance(apex, left), glm::distance(apex, right), glm::distance(left, right)});
}

bool isCornerOfGround(const PlacedTile& tile, GridPoint p)
{
    const int step = tile.grid().cellSide();
    const auto isGround = [&](int east, int north)
    {
        const GridPoint q{p.column + east * step, p.row + north * step};
        return q.column >= 0 && q.row >= 0 && tile.grid().isInData(q.column, q.row) &&
               tile.samples().isGround(q.column, q.row);
    };
    if (!isGround(0, 0)) return false;
    const bool hasDiagonals = ((p.column + p.row) / step) % 2 == 0;
    for (const int east : {-1, 1})
        for (const int north : {-1, 1})
        {
            const bool hasSides = isGround(east, 0) && isGround(0, north);
            const bool hasHalf = isGround(east, north) && (isGround(east, 0) || isGround(0, north));
            if (hasDiagonals ? hasHalf : hasSides) return true;
        }
    return false;
}

} // namespace osgTerrainROAM::core
