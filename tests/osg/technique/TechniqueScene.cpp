// SPDX-License-Identifier: Apache-2.0
#include "TechniqueScene.h"

#include <algorithm>
#include <cmath>

#include <osg/PagedLOD>
#include <osgDB/WriteFile>

namespace techniquescene
{

namespace
{

constexpr double kRadPerM = 3.14159265358979323846 / 180.0 / 3600.0 / 30.0;

osg::ref_ptr<osg::PagedLOD> pagedTile(const TileSpec& spec, const std::string& childFile, double rangeM)
{
    osg::ref_ptr<osg::PagedLOD> paged = new osg::PagedLOD;
    paged->addChild(tileOf(spec), 0.0f, 1e10f);
    paged->setFileName(1, childFile);
    paged->setRange(0, static_cast<float>(rangeM), 1e10f);
    paged->setRange(1, 0.0f, static_cast<float>(rangeM));
    paged->setCenterMode(osg::LOD::USER_DEFINED_CENTER);
    paged->setCenter(osg::Vec3d(spec.x0 + 0.5 * spec.sizeM, spec.y0 + 0.5 * spec.sizeM, 300.0));
    paged->setRadius(static_cast<float>(spec.sizeM));
    return paged;
}

} // namespace

double hillAt(double x, double y)
{
    const double height = 300.0 + 180.0 * std::sin(x * 0.0021) * std::cos(y * 0.0017) +
                          60.0 * std::sin(x * 0.0093 + 1.0) * std::sin(y * 0.0081) +
                          9.0 * std::sin(x * 0.041) * std::cos(y * 0.037);
    return std::floor(height * 64.0) / 64.0;
}

osg::ref_ptr<osgTerrain::Locator> locatorOf(const TileSpec& spec)
{
    osg::ref_ptr<osgTerrain::Locator> locator = new osgTerrain::Locator;
    locator->setCoordinateSystemType(spec.type);
    const double x1 = spec.x0 + spec.sizeM, y1 = spec.y0 + spec.sizeM;
    if (spec.type == osgTerrain::Locator::PROJECTED)
        locator->setTransformAsExtents(spec.x0, spec.y0, x1, y1);
    else
    {
        locator->setEllipsoidModel(new osg::EllipsoidModel);
        const double east = osg::DegreesToRadians(8.0), north = osg::DegreesToRadians(46.0);
        locator->setTransformAsExtents(east + spec.x0 * kRadPerM, north + spec.y0 * kRadPerM,
                                       east + x1 * kRadPerM, north + y1 * kRadPerM);
    }
    return locator;
}

osg::ref_ptr<osgTerrain::HeightFieldLayer> elevationOf(const TileSpec& spec)
{
    osg::ref_ptr<osg::HeightField> heights = new osg::HeightField;
    heights->allocate(static_cast<unsigned>(spec.columns), static_cast<unsigned>(spec.rows));
    for (int row = 0; row < spec.rows; ++row)
        for (int column = 0; column < spec.columns; ++column)
            heights->setHeight(static_cast<unsigned>(column), static_cast<unsigned>(row),
                               static_cast<float>(hillAt(spec.x0 + spec.sizeM * column / (spec.columns - 1),
                                                         spec.y0 + spec.sizeM * row / (spec.rows - 1))));
    return new osgTerrain::HeightFieldLayer(heights);
}

osg::ref_ptr<osg::Image> imageOf(const TileSpec& spec)
{
    constexpr int kSide = 64;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kSide, kSide, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    const auto level = [](double share)
    { return static_cast<unsigned char>(std::clamp(share, 0.0, 1.0) * 255.0); };
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
        {
            unsigned char* texel = image->data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            texel[0] = level(0.3 + 0.7 * x / kSide);
            texel[1] = level(0.3 + 0.7 * y / kSide);
            texel[2] = level((x / 8 + y / 8) % 2 == 0 ? 0.3 : 0.5);
            texel[3] = level(spec.alpha);
        }
    return image;
}

osg::ref_ptr<osgTerrain::TerrainTile> tileOf(const TileSpec& spec)
{
    osg::ref_ptr<osgTerrain::TerrainTile> tile = new osgTerrain::TerrainTile;
    const osg::ref_ptr<osgTerrain::Locator> locator = locatorOf(spec);
    const osg::ref_ptr<osgTerrain::HeightFieldLayer> elevation = elevationOf(spec);
    elevation->setLocator(locator);
    tile->setLocator(locator);
    tile->setElevationLayer(elevation);
    if (!spec.coloured) return tile;
    osg::ref_ptr<osgTerrain::ImageLayer> colours = new osgTerrain::ImageLayer(imageOf(spec));
    colours->setLocator(locator);
    tile->setColorLayer(0, colours);
    return tile;
}

osg::ref_ptr<osgTerrain::Terrain> terrainOf(int side, const TileSpec& spec)
{
    osg::ref_ptr<osgTerrain::Terrain> terrain = new osgTerrain::Terrain;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
        {
            TileSpec part = spec;
            part.x0 += column * spec.sizeM;
            part.y0 += row * spec.sizeM;
            const osg::ref_ptr<osgTerrain::TerrainTile> tile = tileOf(part);
            tile->setTileID({0, column, row});
            terrain->addChild(tile);
        }
    return terrain;
}

std::filesystem::path writePagedDatabase(const std::filesystem::path& folder, double rangeM,
                                         const std::string& extension)
{
    const TileSpec coarse{.sizeM = 3840.0};
    const osg::ref_ptr<osg::Group> children = new osg::Group;
    for (const double y : {0.0, 1920.0})
        for (const double x : {0.0, 1920.0})
            children->addChild(tileOf({.x0 = x, .y0 = y}));
    osgDB::writeNodeFile(*children, (folder / ("children." + extension)).string());
    const osg::ref_ptr<osgTerrain::Terrain> terrain = new osgTerrain::Terrain;
    terrain->addChild(pagedTile(coarse, "children." + extension, rangeM));
    const std::filesystem::path file = folder / ("database." + extension);
    osgDB::writeNodeFile(*terrain, file.string());
    return file;
}

} // namespace techniquescene
