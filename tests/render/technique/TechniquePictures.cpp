// SPDX-License-Identifier: Apache-2.0
#include "TechniquePictures.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include <osgTerrain/GeometryTechnique>

#include "RenderedPicture.h"

namespace techniquepictures
{

std::vector<Viewpoint> viewpoints()
{
    return {{{-500, -600, 1200}, {1900, 1900, 100}},
            {{1930, 500, 520}, {1915, 3000, 250}},
            {{1900, 1700, 2600}, {1920, 1920, 0}},
            {{6000, -4000, 3500}, {1900, 1900, 0}}};
}

Pictures::Pictures(osg::Node* scene)
{
    osgOffscreen::OffscreenSettings settings;
    settings.backend = rendered::backends().front();
    settings.widthPx = kWidthPx;
    settings.heightPx = kHeightPx;
    _viewer = rendered::viewerOf(scene, settings);
    _viewer->camera().setClearColor({1, 0, 1, 1});
    _viewer->camera().setProjectionMatrixAsPerspective(45.0, static_cast<double>(kWidthPx) / kHeightPx, 5.0,
                                                       30000.0);
    _viewer->viewer().setLightingMode(osg::View::SKY_LIGHT);
    osg::Light& light = *_viewer->viewer().getLight();
    light.setPosition(osg::Vec4(-0.5f, -0.4f, 0.7f, 0.0f));
    light.setDiffuse(osg::Vec4(0.9f, 0.9f, 0.85f, 1.0f));
}

osg::ref_ptr<osg::Image> Pictures::from(const Viewpoint& viewpoint)
{
    _viewer->camera().setViewMatrixAsLookAt(viewpoint.eye, viewpoint.target, {0, 0, 1});
    return _viewer->picture();
}

osg::ref_ptr<osgTerrain::Terrain> drawnBy(osgTerrain::TerrainTechnique* technique,
                                          const techniquescene::TileSpec& spec)
{
    const auto terrain = techniquescene::terrainOf(2, spec);
    terrain->setTerrainTechniquePrototype(technique);
    return terrain;
}

osg::ref_ptr<osgTerrain::Terrain> ours(double tolerancePx, const techniquescene::TileSpec& spec)
{
    const osg::ref_ptr<osgTerrainROAM::RoamTechnique> technique = new osgTerrainROAM::RoamTechnique;
    EXPECT_TRUE(technique->setErrorTolerancePx(tolerancePx));
    return drawnBy(technique, spec);
}

osg::ref_ptr<osgTerrain::Terrain> stock(const techniquescene::TileSpec& spec)
{
    return drawnBy(new osgTerrain::GeometryTechnique, spec);
}

void forEachTile(osgTerrain::Terrain& terrain, const std::function<void(osgTerrain::TerrainTile&)>& change)
{
    for (unsigned int i = 0; i < terrain.getNumChildren(); ++i)
        change(static_cast<osgTerrain::TerrainTile&>(*terrain.getChild(i)));
}

std::size_t magentaPixels(const osg::Image& picture)
{
    std::size_t count = 0;
    for (int y = 0; y < picture.t(); ++y)
        for (int x = 0; x < picture.s(); ++x)
        {
            const unsigned char* p = picture.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            count += p[0] == 255 && p[1] == 0 && p[2] == 255;
        }
    return count;
}

Unlikeness unlikeness(const osg::Image& a, const osg::Image& b)
{
    Unlikeness result;
    const double pixels = static_cast<double>(a.s()) * a.t();
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < a.s(); ++x)
        {
            const unsigned char* p = a.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            const unsigned char* q = b.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            int most = 0;
            for (int i = 0; i < 3; ++i)
            {
                const int difference = std::abs(p[i] - q[i]);
                result.mean += difference / (3.0 * pixels);
                most = std::max(most, difference);
            }
            result.shareFar += most > 16 ? 1.0 / pixels : 0.0;
        }
    return result;
}

} // namespace techniquepictures
