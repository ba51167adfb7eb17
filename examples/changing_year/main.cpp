// SPDX-License-Identifier: Apache-2.0
// Shows land cover through the year and into the night. Season and sun are uniforms, so nothing is built
// again:
//   changing_year place.roam FOLDER       writes january.png, may.png, july.png, october.png, dusk.png,
//                                         night.png
#include <cstdio>
#include <filesystem>

#include <osgOffscreen/OffscreenViewer>
#include <osgOffscreen/PngFile>
#include <osgTerrainROAM/RoamTerrain>

namespace
{

using namespace osgTerrainROAM;

struct Moment
{
    const char* name;
    double month;           ///< 1 … 12; the date is its middle
    double sunElevationDeg; ///< below 0 at night
};

constexpr Moment kMoments[] = {{"january", 1, 20},  {"may", 5, 50},   {"july", 7, 55},
                               {"october", 10, 30}, {"dusk", 10, -3}, {"night", 10, -15}};

int failed(const foundation::Error& error)
{
    std::fprintf(stderr, "changing_year: %s\n", error.message().c_str());
    return 1;
}

foundation::Outcome setMoment(RoamTerrain& terrain, osg::Camera& camera, const Moment& moment)
{
    if (auto set = terrain.material()->setSeason((moment.month - 0.5) / 12.0); !set) return set;
    osgSky::AtmosphereSettings air = terrain.atmosphere()->settings();
    air.sunDirectionWorld = osgSky::sunDirectionFromAngles(215.0, moment.sunElevationDeg);
    air.moonlight = 0.7; // lights the ground when the sun has set
    if (auto set = terrain.atmosphere()->setSettings(air); !set) return set;
    const osgSky::AtmosphereLight& light = terrain.atmosphere()->light();
    camera.setClearColor(osg::Vec4(osgSky::displayColour(light.horizon, light.exposure), 1.0f));
    return foundation::success();
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3) return std::fprintf(stderr, "usage: changing_year place.roam FOLDER\n"), 2;
    const auto terrain = openTerrain(argv[1]);
    if (!terrain) return failed(terrain.error());

    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = 640;
    settings.heightPx = 360;
    auto viewer = osgOffscreen::OffscreenViewer::create(settings);
    if (!viewer) return failed(viewer.error());
    osg::Camera& camera = (*viewer)->camera();
    (*viewer)->viewer().setSceneData(terrain->get());
    camera.setProjectionMatrixAsPerspective(45.0, 640.0 / 360.0, 1.0, 60000.0);
    camera.setViewMatrixAsLookAt({-100.0, -1900.0, 650.0}, {0.0, 0.0, 20.0}, {0.0, 0.0, 1.0});

    for (const Moment& moment : kMoments)
    {
        if (const auto set = setMoment(**terrain, camera, moment); !set) return failed(set.error());
        const auto file = std::filesystem::path(argv[2]) / (std::string(moment.name) + ".png");
        if (const auto written = osgOffscreen::writePng(*(*viewer)->picture(), file); !written)
            return failed(written.error());
        std::printf("%s\n", file.c_str());
    }
    return 0;
}
