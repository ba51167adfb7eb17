// SPDX-License-Identifier: Apache-2.0
// Builds a road 7 m wide into a terrain while it is shown, paints it, and makes a crater beside it:
//   built_road dem.tif FOLDER [LENGTH]      writes before.png, driver.png, above.png, undone.png; LENGTH in
//                                           metres
#include <cmath>
#include <cstdio>
#include <cstdlib>
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
    std::fprintf(stderr, "built_road: %s\n", error.message().c_str());
    return 1;
}

/// Returns a gently winding line through the middle of the terrain, from west to east.
core::Ribbon roadThrough(double lengthM)
{
    core::Ribbon road{.crossfall = 0.02, .smoothM = 200.0};
    constexpr int kPoints = 100;
    for (int i = 0; i <= kPoints; ++i)
    {
        const double t = static_cast<double>(i) / kPoints;
        road.points.emplace_back((t - 0.5) * lengthM, 0.06 * lengthM * std::sin(6.0 * t));
    }
    return road;
}

double groundM(const RoamTerrain& terrain, const glm::dvec2& place)
{
    const auto ground = core::groundAt(terrain.tile()->tile, place.x, place.y);
    return ground ? ground->position.z : 0.0;
}

class Photographer
{
public:
    Photographer(osgOffscreen::OffscreenViewer& viewer, std::filesystem::path folder)
        : _viewer(viewer), _folder(std::move(folder))
    {
    }

    foundation::Outcome take(const char* name, const glm::dvec3& eye, const glm::dvec3& at)
    {
        _viewer.camera().setViewMatrixAsLookAt({eye.x, eye.y, eye.z}, {at.x, at.y, at.z}, {0.0, 0.0, 1.0});
        return osgOffscreen::writePng(*_viewer.picture(), _folder / name);
    }

private:
    osgOffscreen::OffscreenViewer& _viewer;
    std::filesystem::path _folder;
};

} // namespace

int main(int argc, char** argv)
{
    if (argc < 3) return std::fprintf(stderr, "usage: built_road dem.tif FOLDER [LENGTH]\n"), 2;
    core::RoamFile description;
    description.dems = {argv[1]};
    description.finestSpacingM = 0.5; // edits may add samples down to this spacing
    const auto made = makeTerrain(description);
    if (!made) return failed(made.error());
    RoamTerrain& terrain = **made;

    auto viewer = osgOffscreen::OffscreenViewer::create({.widthPx = 960, .heightPx = 540});
    if (!viewer) return failed(viewer.error());
    osg::Camera& camera = (*viewer)->camera();
    (*viewer)->viewer().setSceneData(&terrain);
    camera.setProjectionMatrixAsPerspective(45.0, 16.0 / 9.0, 0.5, 60000.0);
    const osgSky::AtmosphereLight& light = terrain.atmosphere()->light();
    camera.setClearColor(osg::Vec4(osgSky::displayColour(light.horizon, light.exposure), 1.0f));
    Photographer photographer(**viewer, argv[2]);

    const double lengthM = argc > 3 ? std::atof(argv[3]) : 1500.0;
    const core::Ribbon road = roadThrough(lengthM);
    const glm::dvec2 start = road.points[40], ahead = road.points[46];
    const auto above = [&](const glm::dvec2& place, double m)
    { return glm::dvec3(place, groundM(terrain, place) + m); };
    const auto fromAbove = [&](const char* name)
    { return photographer.take(name, above(start + glm::dvec2(-400.0, -450.0), 500.0), above(start, 0.0)); };
    if (const auto done = fromAbove("before.png"); !done) return failed(done.error());

    const auto built = terrain.editor()->conform(road);
    if (!built) return failed(built.error());
    const auto paint = core::FeatureCells::build(std::vector{core::GroundFeature{.paths = {road.points}}});
    if (!paint) return failed(paint.error());
    terrain.material()->setFeatures(*paint);
    std::printf("%zu samples, up to %.1f m\n", built->samplesChanged, built->largestChangeM);
    if (const auto done = terrain.editor()->stamp({.centre = ahead + glm::dvec2(10.0, -40.0)}); !done)
        return failed(done.error());
    if (const auto done = photographer.take("driver.png", above(start, 1.5), above(ahead, 1.0)); !done)
        return failed(done.error());
    if (const auto done = fromAbove("above.png"); !done) return failed(done.error());

    while (terrain.editor()->undo())
    {
    }
    if (const auto done = fromAbove("undone.png"); !done) return failed(done.error());
    return 0;
}
