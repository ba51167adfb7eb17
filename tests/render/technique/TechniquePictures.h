// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <osg/Image>
#include <osgTerrain/TerrainTechnique>

#include <osgOffscreen/OffscreenViewer>
#include <osgTerrainROAM/RoamTechnique>

#include "TechniqueScene.h"

namespace techniquepictures
{

struct Viewpoint
{
    osg::Vec3d eye, target;
};

/// Over two by two tiles of 1920 m: from a corner, low along a seam, from above, from far.
std::vector<Viewpoint> viewpoints();

constexpr int kWidthPx = 320, kHeightPx = 180;

/// A scene in magenta, under the light of osgViewer's sky.
class Pictures
{
public:
    explicit Pictures(osg::Node* scene);

    osg::ref_ptr<osg::Image> from(const Viewpoint& viewpoint);
    osgOffscreen::OffscreenViewer& viewer() { return *_viewer; }

private:
    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
};

/// Terrain of two by two tiles with a technique of its own.
osg::ref_ptr<osgTerrain::Terrain> drawnBy(osgTerrain::TerrainTechnique* technique,
                                          const techniquescene::TileSpec& spec = {});
osg::ref_ptr<osgTerrain::Terrain> ours(double tolerancePx = 1.0, const techniquescene::TileSpec& spec = {});
osg::ref_ptr<osgTerrain::Terrain> stock(const techniquescene::TileSpec& spec = {});

/// Calls change(tile) for each tile of a terrain.
void forEachTile(osgTerrain::Terrain& terrain, const std::function<void(osgTerrain::TerrainTile&)>& change);

/// Pixels of the magenta that nothing has been drawn over.
std::size_t magentaPixels(const osg::Image& picture);

/// How two pictures differ, in levels: the mean over all values, and the share of pixels off by more than 16.
struct Unlikeness
{
    double mean = 0.0, shareFar = 0.0;
};
Unlikeness unlikeness(const osg::Image& a, const osg::Image& b);

} // namespace techniquepictures
