// SPDX-License-Identifier: Apache-2.0
// Paints roads, rivers, fields and a runway from a map on a terrain, and writes a picture:
//   painted_ground place.roam picture.png [EAST NORTH HEIGHT HEADING PITCH]      of the eye: metres, degrees;
//                                                                                HEIGHT above ground
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include <osgOffscreen/OffscreenViewer>
#include <osgOffscreen/PngFile>
#include <osgTerrainROAM/RoamTerrain>

namespace
{

int failed(const foundation::Error& error)
{
    std::fprintf(stderr, "painted_ground: %s\n", error.message().c_str());
    return 1;
}

double argument(int argc, char** argv, int index, double otherwise)
{
    return index < argc ? std::atof(argv[index]) : otherwise;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 3) return std::fprintf(stderr, "usage: painted_ground place.roam picture.png [...]\n"), 2;
    // The line `features = FILE` of the .roam file names the map.
    const auto terrain = osgTerrainROAM::openTerrain(argv[1]);
    if (!terrain) return failed(terrain.error());
    std::printf("%s\n", (*terrain)->featureReport().message().c_str());

    const double east = argument(argc, argv, 3, 0.0), north = argument(argc, argv, 4, 0.0);
    const auto ground = osgTerrainROAM::core::groundAt((*terrain)->tile()->tile, east, north);
    if (!ground) return failed({argv[1], "there is no ground at this place", "choose one on the terrain"});
    const osg::Vec3d eye(east, north, ground->position.z + argument(argc, argv, 5, 300.0));
    const double heading = osg::DegreesToRadians(argument(argc, argv, 6, 0.0));
    const double pitch = osg::DegreesToRadians(argument(argc, argv, 7, -30.0));
    const osg::Vec3d ahead(std::sin(heading) * std::cos(pitch), std::cos(heading) * std::cos(pitch),
                           std::sin(pitch));

    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = 960;
    settings.heightPx = 540;
    auto viewer = osgOffscreen::OffscreenViewer::create(settings);
    if (!viewer) return failed(viewer.error());
    (*viewer)->viewer().setSceneData(terrain->get());
    const auto& air = (*terrain)->atmosphere()->light();
    (*viewer)->camera().setClearColor(osg::Vec4(osgSky::displayColour(air.horizon, air.exposure), 1.0f));
    (*viewer)->camera().setProjectionMatrixAsPerspective(45.0, 960.0 / 540.0, 0.5, 60000.0);
    const osg::Vec3d up(std::sin(heading) * -std::sin(pitch), std::cos(heading) * -std::sin(pitch),
                        std::cos(pitch));
    (*viewer)->camera().setViewMatrixAsLookAt(eye, eye + ahead, up);
    const auto written = osgOffscreen::writePng(*(*viewer)->picture(), argv[2]);
    return written ? 0 : failed(written.error());
}
