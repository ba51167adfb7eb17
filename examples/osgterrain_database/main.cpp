// SPDX-License-Identifier: Apache-2.0
// Shows a database of osgTerrain tiles with our technique: osgterrain_database [db.osgb] [--tolerance PIXELS]
// [--once] Without a file it makes four tiles itself, as for stock osgTerrain. A file needs only
// installTechnique(), also for its paged children.
#include <cmath>
#include <cstdio>

#include <osgDB/ReadFile>
#include <osgGA/TerrainManipulator>
#include <osgTerrain/Layer>
#include <osgTerrain/Terrain>
#include <osgTerrain/TerrainTile>
#include <osgViewer/Viewer>

#include <osgTerrainROAM/RoamTechnique>

namespace
{

constexpr unsigned int kSamples = 129;
constexpr double kSideM = 3840.0;

osg::ref_ptr<osgTerrain::TerrainTile> madeTile(double x0, double y0)
{
    osg::ref_ptr<osg::HeightField> heights = new osg::HeightField;
    heights->allocate(kSamples, kSamples);
    for (unsigned int row = 0; row < kSamples; ++row)
        for (unsigned int column = 0; column < kSamples; ++column)
        {
            const double x = x0 + kSideM * column / (kSamples - 1), y = y0 + kSideM * row / (kSamples - 1);
            heights->setHeight(column, row,
                               static_cast<float>(250.0 * std::sin(x * 0.0011) * std::cos(y * 0.0013) +
                                                  30.0 * std::sin(x * 0.011 + y * 0.007)));
        }
    osg::ref_ptr<osgTerrain::Locator> locator = new osgTerrain::Locator;
    locator->setCoordinateSystemType(osgTerrain::Locator::PROJECTED);
    locator->setTransformAsExtents(x0, y0, x0 + kSideM, y0 + kSideM);
    osg::ref_ptr<osgTerrain::HeightFieldLayer> elevation = new osgTerrain::HeightFieldLayer(heights);
    elevation->setLocator(locator);

    osg::ref_ptr<osg::TransferFunction1D> colours = new osg::TransferFunction1D;
    colours->setColor(-280.0f, osg::Vec4(0.3f, 0.5f, 0.2f, 1.0f));
    colours->setColor(280.0f, osg::Vec4(0.9f, 0.85f, 0.7f, 1.0f));
    osg::ref_ptr<osgTerrain::ContourLayer> contour = new osgTerrain::ContourLayer(colours);
    contour->setLocator(locator);

    osg::ref_ptr<osgTerrain::TerrainTile> tile = new osgTerrain::TerrainTile;
    tile->setLocator(locator);
    tile->setElevationLayer(elevation);
    tile->setColorLayer(0, contour);
    return tile;
}

osg::ref_ptr<osg::Node> madeDatabase()
{
    osg::ref_ptr<osgTerrain::Terrain> terrain = new osgTerrain::Terrain;
    for (const double y : {0.0, kSideM})
        for (const double x : {0.0, kSideM})
            terrain->addChild(madeTile(x, y));
    return terrain;
}

} // namespace

int main(int argc, char** argv)
{
    osg::ArgumentParser arguments(&argc, argv);
    osg::ref_ptr<osgTerrainROAM::RoamTechnique> technique = new osgTerrainROAM::RoamTechnique;
    double tolerancePx = technique->settings().errorTolerancePx;
    arguments.read("--tolerance", tolerancePx);
    if (const auto set = technique->setErrorTolerancePx(tolerancePx); !set)
        return std::fprintf(stderr, "%s\n", set.error().message().c_str()), 1;
    const bool once = arguments.read("--once"); // one frame, for the tests

    const osg::ref_ptr<osg::Node> database = argc > 1 ? osgDB::readRefNodeFile(arguments[1]) : madeDatabase();
    if (!database) return 1; // osgDB has printed the reason
    const auto found = osgTerrainROAM::installTechnique(*database, *technique);
    std::printf("%u tiles, %u files to page in\n", found.tiles, found.pagedFiles);

    osgViewer::Viewer viewer;
    viewer.setSceneData(database);
    viewer.setCameraManipulator(new osgGA::TerrainManipulator);
    if (!once) return viewer.run();
    viewer.frame();
    return 0;
}
