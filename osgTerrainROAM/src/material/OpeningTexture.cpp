// SPDX-License-Identifier: Apache-2.0
#include "OpeningTexture.h"

#include <cstring>

#include <osg/Texture2D>
#include <osg/Uniform>

namespace osgTerrainROAM
{

namespace
{

constexpr std::size_t kTexelsPerRow = 1024; ///< a power of two: the shader divides by a shift and a mask

osg::ref_ptr<osg::Image> openingImage(const core::OpeningCells& cells)
{
    const std::size_t texels = cells.cells.size() + cells.records.size();
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kTexelsPerRow, static_cast<int>((texels + kTexelsPerRow - 1) / kTexelsPerRow), 1,
                         GL_RGBA, GL_FLOAT);
    image->setInternalTextureFormat(GL_RGBA32F_ARB);
    std::memset(image->data(), 0, image->getTotalSizeInBytes());
    auto* out = reinterpret_cast<float*>(image->data());
    for (const core::OpeningCells::Cell& cell : cells.cells)
    {
        out[0] = static_cast<float>(cells.cells.size() + cell.first);
        out[1] = static_cast<float>(cell.pieces);
        out += 4;
    }
    if (!cells.records.empty())
        std::memcpy(out, cells.records.data(), cells.records.size() * sizeof(cells.records[0]));
    return image;
}

} // namespace

void addOpeningTexture(osg::StateSet& stateSet, const core::OpeningCells& cells, int unit)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(openingImage(cells));
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    stateSet.setTextureAttributeAndModes(static_cast<unsigned>(unit), texture);
    stateSet.addUniform(new osg::Uniform("openingTexels", unit));
    osg::ref_ptr<osg::Uniform> grid = new osg::Uniform(osg::Uniform::INT_VEC4, "openingGrid");
    grid->set(cells.firstCell.x, cells.firstCell.y, cells.columns, cells.rows);
    stateSet.addUniform(grid);
    stateSet.addUniform(new osg::Uniform("openingCellM", static_cast<float>(cells.cellM)));
}

} // namespace osgTerrainROAM
