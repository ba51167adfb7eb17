// SPDX-License-Identifier: Apache-2.0
#include "TileBounds.h"

#include <algorithm>
#include <limits>

#include <osgTerrainROAM/core/heightfield/SampleRaster.h>

namespace osgTerrainROAM
{

namespace
{

constexpr int kBlock = 16; ///< cells

/// Between its corners a block of the round Earth bulges by chord²/8R; 16 cells of 1 km make 5 m.
double bulgeM(const core::PlacedTile& tile)
{
    const double chord = 1.5 * kBlock * std::max(tile.field().spacingEastM, tile.field().spacingNorthM);
    return chord * chord / (8.0 * 6.35e6) + 0.01;
}

} // namespace

osg::BoundingBox tileBounds(const core::PlacedTile& placed)
{
    const core::SampleRaster tile(placed);
    osg::BoundingBox box;
    const int lastColumn = tile.dataColumns() - 1;
    const int lastRow = tile.dataRows() - 1;
    for (int row = 0; row < lastRow; row += kBlock)
        for (int column = 0; column < lastColumn; column += kBlock)
        {
            const int rowEnd = std::min(row + kBlock, lastRow);
            const int columnEnd = std::min(column + kBlock, lastColumn);
            float low = std::numeric_limits<float>::max();
            float high = std::numeric_limits<float>::lowest();
            for (int r = row; r <= rowEnd; ++r)
                for (int c = column; c <= columnEnd; ++c)
                {
                    low = std::min(low, tile.heightM(c, r));
                    high = std::max(high, tile.heightM(c, r));
                }
            for (const int r : {row, rowEnd})
                for (const int c : {column, columnEnd})
                    for (const float height : {low, high})
                    {
                        const glm::dvec3 p = tile.positionAt(c, r, height);
                        box.expandBy(osg::Vec3f(static_cast<float>(p.x), static_cast<float>(p.y),
                                                static_cast<float>(p.z)));
                    }
        }
    for (const core::SampleSheet& sheet : placed.samples().sheets())
        sheet.rect().forEachMultipleOf(sheet.step(),
                                       [&](int column, int row)
                                       {
                                           const glm::dvec3 p = placed.position(column, row);
                                           box.expandBy(osg::Vec3d(p.x, p.y, p.z));
                                       });
    const auto margin = static_cast<float>(bulgeM(placed));
    box._min -= osg::Vec3f(margin, margin, margin);
    box._max += osg::Vec3f(margin, margin, margin);
    return box;
}

} // namespace osgTerrainROAM
