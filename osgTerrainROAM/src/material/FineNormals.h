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

/// Normals of what edits have put between the samples of a tile, for shading: the normal map has one texel a sample. A cell
/// of the raster that has such gets a page, a layer of a texture array, and an index texture says which. A page's texels
/// hold the normal's x and y, and the share in which they count: where the surface is the raster's, the normal map does.
/// Beyond kMostPages cells are shaded by the normal map alone.
/// Threads: the update phase. Memory: 175 kB a page, here and on the graphics card.
class FineNormals
{
public:
    static constexpr int kMostPages = 512;
    static constexpr int kPageSide = 128; ///< texels, or as many as a cell has places

    /// Texture units: of the index, and of the pages.
    FineNormals(const core::PlacedTile& tile, osg::StateSet& stateSet, unsigned indexUnit, unsigned pageUnit);

    /// Draws the pages of the cells again that touch what has changed. Cost: about 1 µs a texel.
    void follow(const core::PlacedTile& tile, std::span<const core::GridRect> moved);

    std::size_t pages() const { return _pageOf.size(); }

private:
    void drawCell(const core::PlacedTile& tile, int column, int row);
    int pageFor(int column, int row);
    void grow();

    int _cellShift; ///< log2 of the places along a cell
    int _side;      ///< texels along a page
    osg::ref_ptr<osg::Image> _index;
    osg::ref_ptr<osg::Texture2DArray> _pages;
    std::unordered_map<std::uint64_t, int> _pageOf; ///< by cell
};

} // namespace osgTerrainROAM
