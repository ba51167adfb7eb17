// SPDX-License-Identifier: Apache-2.0
#include "ColourLayers.h"

#include <algorithm>

#include <osg/Texture1D>
#include <osg/Texture2D>
#include <osgTerrain/Layer>
#include <osgTerrain/Terrain>

namespace osgTerrainROAM
{

namespace
{

using osgTerrain::Layer;
using osgTerrain::TerrainTile;

/// The layer that shows: through switches and composites.
const Layer* shown(const Layer* layer)
{
    if (const auto* choice = dynamic_cast<const osgTerrain::SwitchLayer*>(layer))
        return choice->getActiveLayer() < 0
                   ? nullptr
                   : shown(choice->getLayer(static_cast<unsigned int>(choice->getActiveLayer())));
    const auto* composite = dynamic_cast<const osgTerrain::CompositeLayer*>(layer);
    for (unsigned int i = 0; composite && i < composite->getNumLayers(); ++i)
        if (const Layer* part = shown(composite->getLayer(i)); part && part->getImage()) return part;
    return composite ? nullptr : layer;
}

void setUp(osg::Texture& texture, const Layer& layer)
{
    texture.setResizeNonPowerOfTwoHint(false);
    texture.setFilter(osg::Texture::MIN_FILTER, layer.getMinFilter());
    texture.setFilter(osg::Texture::MAG_FILTER, layer.getMagFilter());
    texture.setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture.setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
}

/// Coefficients of the bilinear map with the given values at the corners (0,0), (1,0), (0,1), (1,1).
osg::Vec4f bilinear(double a, double b, double c, double d)
{
    return {static_cast<float>(a), static_cast<float>(b - a), static_cast<float>(c - a),
            static_cast<float>(d - b - c + a)};
}

void placeImage(ColourLayer& drawn, const osgTerrain::Locator* locator, const osgTerrain::Locator& master)
{
    osg::Vec3d corners[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    if (locator && locator != &master)
        for (osg::Vec3d& corner : corners)
        {
            osg::Vec3d there = corner;
            if (osgTerrain::Locator::convertLocalCoordBetween(master, corner, *locator, there))
                corner = there;
        }
    drawn.s = bilinear(corners[0].x(), corners[1].x(), corners[2].x(), corners[3].x());
    drawn.t = bilinear(corners[0].y(), corners[1].y(), corners[2].y(), corners[3].y());
}

ColourLayer imageLayer(const Layer& layer, osg::Image* image, const osgTerrain::Locator* locator,
                       const osgTerrain::Locator& master)
{
    ColourLayer drawn;
    drawn.kind = image->getPixelFormat() == GL_ALPHA ? LayerKind::alpha : LayerKind::image;
    drawn.texture = new osg::Texture2D(image);
    setUp(*drawn.texture, layer);
    drawn.texture->setMaxAnisotropy(16.0f);
    placeImage(drawn, locator, master);
    return drawn;
}

ColourLayer contourLayer(const osgTerrain::ContourLayer& layer, osg::Image* image)
{
    ColourLayer drawn;
    drawn.kind = LayerKind::contour;
    drawn.texture = new osg::Texture1D(image);
    setUp(*drawn.texture, layer);
    drawn.texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    const float from = layer.getTransferFunction()->getMinimum();
    const float range = layer.getTransferFunction()->getMaximum() - from;
    if (range != 0.0f) drawn.s = osg::Vec4f(-from / range, 1.0f / range, 0.0f, 0.0f);
    return drawn;
}

} // namespace

std::vector<ColourLayer> colourLayers(const TerrainTile& tile, const osgTerrain::Locator& master)
{
    std::vector<ColourLayer> layers;
    for (unsigned int unit = 0; unit < std::min(tile.getNumColorLayers(), kMostLayers); ++unit)
    {
        const Layer* layer = shown(tile.getColorLayer(unit));
        osg::Image* image = layer ? const_cast<osg::Image*>(layer->getImage()) : nullptr;
        if (!image) continue;
        const osgTerrain::Locator* locator = tile.getColorLayer(unit)->getLocator();
        const auto* contour = dynamic_cast<const osgTerrain::ContourLayer*>(layer);
        layers.push_back(contour
                             ? contourLayer(*contour, image)
                             : imageLayer(*layer, image, locator ? locator : layer->getLocator(), master));
        layers.back().unit = unit;
    }
    return layers;
}

bool blends(const TerrainTile& tile)
{
    TerrainTile::BlendingPolicy policy = tile.getBlendingPolicy();
    if (policy == TerrainTile::INHERIT && tile.getTerrain()) policy = tile.getTerrain()->getBlendingPolicy();
    if (policy == TerrainTile::DO_NOT_SET_BLENDING || policy == TerrainTile::ENABLE_BLENDING)
        return policy == TerrainTile::ENABLE_BLENDING;
    for (unsigned int i = 0; i < tile.getNumColorLayers(); ++i)
        if (const osg::Image* image = tile.getColorLayer(i) ? tile.getColorLayer(i)->getImage() : nullptr)
            return image->isImageTranslucent();
    return false;
}

} // namespace osgTerrainROAM
