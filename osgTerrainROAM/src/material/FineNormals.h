// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>

#include <osg/Image>
#include <osg/StateSet>
#include <osg/Texture2D>
#include <osg/Texture2DArray>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM
{

/// Normals of edited ground between the samples of a tile, for shading; the normal map has one texel a sample
/// only. A cell of the raster with such ground has a page, a layer of a texture array; an index texture holds
/// its number. A texel of a page holds x and y of the normal and their weight: where the surface is the
/// raster's, the weight is 0 and the normal map counts. When kMostPages are in use, further cells are shaded
/// by the normal map alone.
/// Threads: the update phase. Memory: 175 kB a page, here and on the graphics card.
class FineNormals
{
public:
    static constexpr int kMostPages = 512;
    static constexpr int kPageSide = 128; ///< texels; fewer where a cell has fewer grid positions

    /// `indexUnit`, `pageUnit`: texture units of the index and of the pages.
    FineNormals(const core::PlacedTile& tile, osg::StateSet& stateSet, unsigned indexUnit, unsigned pageUnit);

    /// Computes the pages again of all cells that touch changed ground. Cost: about 1 µs a texel.
    void follow(const core::PlacedTile& tile, std::span<const core::GridRect> moved);

    std::size_t pages() const { return _pageOf.size(); }

private:
    void drawCell(const core::PlacedTile& tile, int column, int row);
    int pageFor(int column, int row);
    void grow();

    int _cellShift; ///< log2 of the grid positions along a cell
    int _side;      ///< of a page, texels
    osg::ref_ptr<osg::Image> _index;
    osg::ref_ptr<osg::Texture2DArray> _pages;
    std::unordered_map<std::uint64_t, int> _pageOf; ///< by cell
};

} // namespace osgTerrainROAM
