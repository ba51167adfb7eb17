// SPDX-License-Identifier: Apache-2.0
// Joins several elevation rasters of different extents and spacings to one terrain:
//   joined_terrain place.roam FOLDER      prints how they were joined, writes above.png and across.png
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include <osgOffscreen/OffscreenViewer>
#include <osgOffscreen/PngFile>
#include <osgTerrainROAM/RoamTerrain>

namespace
{

using namespace osgTerrainROAM;

int failed(const foundation::Error& error)
{
    std::fprintf(stderr, "joined_terrain: %s\n", error.message().c_str());
    return 1;
}

void report(const core::PlacedTile& tile)
{
    const core::HeightField& field = tile.field();
    std::printf("%d rasters on a grid of %d x %d samples, %.1f m apart\n", field.mosaic.rasters,
                field.columns, field.rows, field.spacingNorthM);
    std::printf("%.1f m is the most by which they disagreed; %zu samples were bent\n",
                field.mosaic.largestStepM, field.mosaic.bentSamples);
    for (const core::SampleSheet& sheet : tile.samples().sheets())
        std::printf("a denser part of %zu samples\n", sheet.table().size());
}

/// Returns the share of the grid that has no ground: the outline of the rasters is not a rectangle.
double shareOfHoles(const core::PlacedTile& tile)
{
    constexpr int kLooks = 100;
    int missing = 0;
    for (int i = 0; i < kLooks; ++i)
        for (int j = 0; j < kLooks; ++j)
        {
            const glm::dvec3 place =
                tile.frame().positionAt((tile.grid().dataColumns() - 1) * (i + 0.5) / kLooks,
                                        (tile.grid().dataRows() - 1) * (j + 0.5) / kLooks, 0.0);
            missing += core::groundAt(tile, place.x, place.y) ? 0 : 1;
        }
    return static_cast<double>(missing) / (kLooks * kLooks);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 3) return std::fprintf(stderr, "usage: joined_terrain place.roam FOLDER\n"), 2;
    // Each line `dem = FILE` of the .roam file names one of them.
    const auto terrain = openTerrain(argv[1]);
    if (!terrain) return failed(terrain.error());
    const core::PlacedTile& tile = (*terrain)->tile()->tile;
    report(tile);
    std::printf("%.0f %% of the grid is reached by none\n", 100.0 * shareOfHoles(tile));

    auto viewer = osgOffscreen::OffscreenViewer::create({.widthPx = 960, .heightPx = 540});
    if (!viewer) return failed(viewer.error());
    osg::Camera& camera = (*viewer)->camera();
    (*viewer)->viewer().setSceneData(terrain->get());
    camera.setProjectionMatrixAsPerspective(45.0, 16.0 / 9.0, 1.0, 200000.0);
    const osgSky::AtmosphereLight& light = (*terrain)->atmosphere()->light();
    camera.setClearColor(osg::Vec4(osgSky::displayColour(light.horizon, light.exposure), 1.0f));
    const osg::BoundingSphere all = (*terrain)->getBound();
    const osg::Vec3d middle = all.center();
    const auto take = [&](const char* name, const osg::Vec3d& from)
    {
        camera.setViewMatrixAsLookAt(middle + from * all.radius(), middle, {0.0, 1.0, 0.1});
        return osgOffscreen::writePng(*(*viewer)->picture(), std::filesystem::path(argv[2]) / name);
    };
    if (const auto done = take("above.png", {0.0, 0.0, 1.9}); !done) return failed(done.error());
    if (const auto done = take("across.png", {0.1, -0.9, 0.45}); !done) return failed(done.error());
    return 0;
}
