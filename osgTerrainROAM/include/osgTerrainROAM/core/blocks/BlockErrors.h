// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/blocks/BlockBounds.h>
#include <osgTerrainROAM/core/blocks/BlockTriangles.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// The exact error of every level of every block, and of every border, for regular decimation.
/// An error is the largest |X(s) - surface at s| over the samples s of the data that the triangles hold, both
/// in 3D: the surface is taken at the sample's place in grid indices, so the Earth's curvature is in it.
/// Errors of levels above 0 include the rounding of vertices.
/// Frame: the tile's. Units: metres. Memory: 4 B for each pair of levels and side: about 0.5 B a sample. Cost
/// of measuring: about 1 µs a sample.
class BlockErrors
{
public:
    BlockErrors(std::shared_ptr<const RoamTile> tile, const BlockGrid& grid);

    const RoamTile& tile() const { return *_tile; }
    const BlockGrid& grid() const { return _grid; }
    int levels() const { return _levels; } ///< of each block: the exponent of its side, and 1

    /// Of a block whose borders all have its level. It does not fall with the level.
    double blockM(std::uint32_t block, int level) const { return _blocksM[index(block, level)]; }

    /// Of the strip along a side where the border has a level.
    double stripM(std::uint32_t block, int level, int side, int border) const
    {
        return _stripsM[stripIndex(block, level, side, border)];
    }

    /// Of a block that is at a level exactly, while its borders have any state between that level and two
    /// above: bounds what morphing draws. It does not fall with the level.
    double morphedM(std::uint32_t block, int level) const { return _morphedM[index(block, level)]; }

    const BlockBox& box(std::uint32_t block) const { return _boxes[block]; }

    /// Measures the blocks anew that hold points of rectangles.
    void remeasure(std::span<const GridRect> rects);

    std::uint64_t revision() const { return _revision; } ///< of the tile when it was measured
    std::size_t memoryBytes() const;

private:
    friend struct BlockErrorsMutation;

    std::size_t index(std::uint32_t block, int level) const
    {
        return static_cast<std::size_t>(block) * static_cast<std::size_t>(_levels) +
               static_cast<std::size_t>(level);
    }
    std::size_t stripIndex(std::uint32_t block, int level, int side, int border) const
    {
        return (index(block, level) * kSides + static_cast<std::size_t>(side)) *
                   static_cast<std::size_t>(_levels) +
               static_cast<std::size_t>(border);
    }
    void measure(std::uint32_t block);

    std::shared_ptr<const RoamTile> _tile;
    BlockGrid _grid;
    int _levels;
    std::vector<float> _blocksM, _stripsM, _morphedM;
    std::vector<BlockBox> _boxes;
    std::uint64_t _revision = 0;
};

} // namespace osgTerrainROAM::core
