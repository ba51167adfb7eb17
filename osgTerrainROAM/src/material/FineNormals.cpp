// SPDX-License-Identifier: Apache-2.0
#include "FineNormals.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <osg/Uniform>

#include "NormalMap.h"

namespace osgTerrainROAM
{

namespace
{

constexpr int kFirstCapacity = 16;

std::uint64_t keyOf(int column, int row)
{
    return static_cast<std::uint64_t>(row) << 32 | static_cast<std::uint64_t>(column);
}

/// The normal by central differences of positions, `reach` grid positions to each side.
glm::dvec3 normalAt(const core::PlacedTile& tile, int column, int row, int reach)
{
    const int west = std::max(column - reach, 0),
              east = std::min(column + reach, tile.grid().dataColumns() - 1);
    const int south = std::max(row - reach, 0), north = std::min(row + reach, tile.grid().dataRows() - 1);
    return glm::normalize(glm::cross(tile.position(east, row) - tile.position(west, row),
                                     tile.position(column, north) - tile.position(column, south)));
}

} // namespace

FineNormals::FineNormals(const core::PlacedTile& tile, osg::StateSet& stateSet, unsigned indexUnit,
                         unsigned pageUnit)
    : _cellShift(tile.grid().exponent()),
      _side(std::min(kPageSide, tile.grid().cellSide())),
      _index(new osg::Image)
{
    _index->allocateImage(tile.field().columns - 1, tile.field().rows - 1, 1, GL_RED, GL_UNSIGNED_SHORT);
    _index->setInternalTextureFormat(GL_R16);
    std::memset(_index->data(), 0, _index->getTotalSizeInBytes());
    const auto texture =
        [&](unsigned unit, osg::Texture* made, osg::Texture::FilterMode filter, const char* name)
    {
        made->setResizeNonPowerOfTwoHint(false);
        made->setFilter(osg::Texture::MIN_FILTER, filter);
        made->setFilter(osg::Texture::MAG_FILTER,
                        filter == osg::Texture::NEAREST ? filter : osg::Texture::LINEAR);
        made->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
        made->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
        stateSet.setTextureAttribute(unit, made);
        stateSet.addUniform(new osg::Uniform(name, static_cast<int>(unit)));
    };
    _index->setDataVariance(osg::Object::DYNAMIC);
    texture(indexUnit, new osg::Texture2D(_index), osg::Texture::NEAREST, "terrainFineIndex");
    _pages = new osg::Texture2DArray;
    _pages->setTextureSize(_side, _side, kFirstCapacity);
    _pages->setInternalFormat(GL_RGBA16);
    _pages->setSourceFormat(GL_RGBA);
    _pages->setSourceType(GL_UNSIGNED_SHORT);
    texture(pageUnit, _pages, osg::Texture::LINEAR, "terrainFineNormals");
    stateSet.addUniform(
        new osg::Uniform("terrainCellsPerPlace", static_cast<float>(std::ldexp(1.0, -_cellShift))));
}

void FineNormals::follow(const core::PlacedTile& tile, std::span<const core::GridRect> moved)
{
    if (tile.samples().fineSamples().isEmpty()) return;
    const core::GridRect cells{0, 0, _index->s() - 1, _index->t() - 1};
    std::unordered_map<std::uint64_t, bool> seen;
    for (const core::GridRect& rect : moved)
    {
        const core::GridRect touched = core::GridRect{rect.west >> _cellShift, rect.south >> _cellShift,
                                                      rect.east >> _cellShift, rect.north >> _cellShift}
                                           .cutTo(cells);
        for (int row = touched.south; row <= touched.north; ++row)
            for (int column = touched.west; column <= touched.east; ++column)
                if (seen.emplace(keyOf(column, row), true).second) drawCell(tile, column, row);
    }
}

/// A texel counts where it has a sample that is not one of the raster.
void FineNormals::drawCell(const core::PlacedTile& tile, int column, int row)
{
    const int cell = 1 << _cellShift, step = cell / _side;
    const int west = column << _cellShift, south = row << _cellShift;
    bool isFine = _pageOf.contains(keyOf(column, row));
    if (!isFine)
        tile.samples().fineSamples().forEachIn({west, south, west + cell, south + cell}, [&](int c, int r)
                                               { isFine = isFine || tile.samples().hasFineSample(c, r); });
    const int page = isFine ? pageFor(column, row) : -1;
    if (page < 0) return;
    osg::Image& image = *_pages->getImage(static_cast<unsigned>(page));
    const int reach = std::max(step / 2, 1);
    for (int y = 0; y < _side; ++y)
    {
        auto* out = reinterpret_cast<std::uint16_t*>(image.data(0, y));
        for (int x = 0; x < _side; ++x, out += 4)
        {
            const int c = west + x * step + step / 2, r = south + y * step + step / 2;
            const bool counts = tile.samples().hasFineSample(c, r) ||
                                tile.samples().hasFineSample(c - reach, r - reach) ||
                                tile.samples().hasFineSample(c + reach, r + reach);
            const glm::dvec3 normal = counts ? normalAt(tile, c, r, reach) : glm::dvec3(0.0, 0.0, 1.0);
            packNormal(normal, out);
            out[2] = counts ? 65535 : 0;
            out[3] = 65535;
        }
    }
    image.dirty();
}

int FineNormals::pageFor(int column, int row)
{
    const auto [found, isNew] = _pageOf.try_emplace(keyOf(column, row), static_cast<int>(_pageOf.size()));
    if (!isNew) return found->second;
    if (found->second >= kMostPages)
    {
        _pageOf.erase(found);
        return -1;
    }
    if (found->second >= _pages->getTextureDepth()) grow();
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(_side, _side, 1, GL_RGBA, GL_UNSIGNED_SHORT);
    image->setInternalTextureFormat(GL_RGBA16);
    _pages->setImage(static_cast<unsigned>(found->second), image);
    *reinterpret_cast<std::uint16_t*>(_index->data(column, row)) =
        static_cast<std::uint16_t>(found->second + 1);
    _index->dirty();
    return found->second;
}

/// Doubles the texture array. It cannot grow in place: each graphics context makes it anew.
void FineNormals::grow()
{
    _pages->setTextureSize(_side, _side, 2 * _pages->getTextureDepth());
    _pages->dirtyTextureObject();
}

} // namespace osgTerrainROAM
