// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/Texture>
#include <osg/Vec4f>
#include <osgTerrain/TerrainTile>

namespace osgTerrainROAM
{

/// The blending of a colour layer over the tile.
enum class LayerKind : char
{
    image = 'i',
    alpha = 'a',   ///< an image of alpha alone: multiplies alpha, leaves the colour
    contour = 'c', ///< colours by height
};

/// A colour layer in drawable form.
struct ColourLayer
{
    LayerKind kind = LayerKind::image;
    unsigned int unit = 0; ///< texture unit: the layer's number
    osg::ref_ptr<osg::Texture> texture;
    /// Images: weights of 1, u, v and u·v, which run from 0 to 1 over the tile, in the texture's coordinates.
    /// Contours: the coordinate is s.x + s.y · the layer's height.
    osg::Vec4f s, t;
};

/// The number of layers that are drawn: stock osgTerrain has as many texture coordinates.
inline constexpr unsigned int kMostLayers = 8;

/// The colour layers of a tile that have an image: of a SwitchLayer the active one, of a CompositeLayer the
/// first. A layer with a locator of its own is placed at the tile's corners and bilinearly between.
std::vector<ColourLayer> colourLayers(const osgTerrain::TerrainTile& tile, const osgTerrain::Locator& master);

/// Whether the tile blends, decided as GeometryTechnique does: by the tile's policy, else its terrain's, else
/// by the first image's alpha.
bool blends(const osgTerrain::TerrainTile& tile);

} // namespace osgTerrainROAM
