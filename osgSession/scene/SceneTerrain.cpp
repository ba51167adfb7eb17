// SPDX-License-Identifier: Apache-2.0
#include "SceneTerrain.h"

#include <algorithm>
#include <array>
#include <iostream>

#include <foundation/ReadableFile.h>

#include <osg/MatrixTransform>
#include <osg/NodeVisitor>
#include <osgDB/FileNameUtils>
#include <osgDB/Registry>

#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/heightfield/DemCheck.h>

#include <osgMultiTriangulation/OpenMultiTriangulation>

#include "ModelFile.h"
#include "SceneRoads.h"
#include "scenery/ground/TileGround.h"

namespace trainer
{

namespace
{

using osgTerrainROAM::RoamTerrain;

/// Finds the first ROAM terrain of a scene.
class TerrainFinder : public osg::NodeVisitor
{
public:
    TerrainFinder() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}

    void apply(osg::Group& group) override
    {
        if (auto* terrain = dynamic_cast<RoamTerrain*>(&group); terrain && !found) found = terrain;
        traverse(group);
    }

    osg::ref_ptr<RoamTerrain> found;
};

bool isTerrainFile(const std::filesystem::path& file)
{
    static constexpr std::array kSuffixes{"roam", "xodr", "mt",  "tif", "tiff", "hgt", "gz",  "zip",
                                          "asc",  "dt0",  "dt1", "dt2", "png",  "img", "vrt", "bil"};
    const std::string suffix = osgDB::getLowerCaseFileExtension(file.string());
    std::error_code failed;
    return std::filesystem::is_directory(file, failed) ||
           std::find(kSuffixes.begin(), kSuffixes.end(), suffix) != kSuffixes.end();
}

/// Frames wait for detail, so that captures repeat; a window does not let them.
foundation::Result<SceneTerrain> openTriangulation(const std::filesystem::path& file)
{
    const auto opened = osgMultiTriangulation::openMultiTriangulation(file, {.waits = true});
    if (!opened) return opened.error();
    SceneTerrain scene{opened->terrain, opened->terrain, nullptr};
    scene.triangulation = opened->drawable;
    return scene;
}

} // namespace

std::optional<simulation::Geodetic> SceneTerrain::origin() const
{
    return terrain ? ground::originOf(terrain->tile()->tile) : std::nullopt;
}

simulation::GroundProvider SceneTerrain::ground() const
{
    if (!terrain) return {};
    simulation::GroundProvider surface = ground::groundOf(terrain->tile()->tile);
    if (roads) surface = groundWithRoads(std::move(surface), roads);
    if (cornerM == glm::dvec2(0.0)) return surface;
    return [surface = std::move(surface), corner = cornerM](double eastM, double northM, double fromM)
    { return surface(eastM - corner.x, northM - corner.y, fromM); };
}

SceneTerrain moved(SceneTerrain scene, const glm::dvec2& corner)
{
    const osg::ref_ptr<osg::MatrixTransform> place =
        new osg::MatrixTransform(osg::Matrixd::translate(corner.x, corner.y, 0.0));
    place->addChild(scene.node);
    scene.node = place;
    scene.cornerM = corner;
    for (glm::dvec2& house : scene.houses)
        house += corner;
    if (scene.obstacles)
        scene.obstacles = std::make_shared<const simulation::ObstacleMap>(scene.obstacles->moved(corner));
    return scene;
}

foundation::Outcome checkElevation(const std::filesystem::path& file, const TerrainRequest& request)
{
    const std::string suffix = osgDB::getLowerCaseFileExtension(file.string());
    if (suffix == "xodr" || suffix == "mt") return foundation::checkReadable(file);
    const auto description = osgTerrainROAM::core::describeTerrain(file, request.import);
    if (!description) return description.error();
    return osgTerrainROAM::core::checkDems(description->dems, description->import);
}

foundation::Outcome checkScene(const std::filesystem::path& file, const TerrainRequest& request)
{
    return isTerrainFile(file) ? checkElevation(file, request) : foundation::success();
}

foundation::Result<SceneTerrain> openElevation(const std::filesystem::path& file,
                                               const TerrainRequest& request)
{
    const auto watch = request.opening->watched("opens " + file.string());
    request.opening->end("program");
    if (osgDB::getLowerCaseFileExtension(file.string()) == "xodr") return openNetwork(file, request);
    if (osgDB::getLowerCaseFileExtension(file.string()) == "mt") return openTriangulation(file);
    auto description = osgTerrainROAM::core::describeTerrain(file, request.import);
    if (!description) return description.error();
    description->showsVoids = description->showsVoids || request.showsVoids;
    std::optional<std::vector<simulation::CloudLayer>> clouds;
    if (!description->clouds.empty())
    {
        auto read = simulation::readCloudLayers(description->clouds, file.string() + ", clouds");
        if (!read) return read.error();
        clouds = *std::move(read);
    }
    std::optional<simulation::SurfaceWeather> ground;
    if (!description->ground.empty())
    {
        const auto read = simulation::readSurfaceWeather(description->ground, file.string() + ", ground");
        if (!read) return read.error();
        ground = *read;
    }
    auto scene = makeTerrainWithRoads(*description, request);
    if (!scene) return scene;
    scene->clouds = std::move(clouds);
    scene->air.ground = ground;
    for (const std::string& note : scene->terrain->tile()->tile.field().notes)
        std::cout << "note: " << note << '\n';
    if (description->sunAzimuthDeg && description->sunElevationDeg)
        scene->air.sun = {*description->sunAzimuthDeg, *description->sunElevationDeg};
    scene->air.visibilityM = description->visibilityM;
    scene->moonlight = description->moonlight;
    if (description->land.seaLevelM)
    {
        const auto& frame = scene->terrain->tile()->tile.frame();
        const glm::dvec2 grid = frame.gridNear(glm::dvec2(0.0));
        scene->seaLevelM = frame.positionAt(grid.x, grid.y, *description->land.seaLevelM).z;
    }
    return scene;
}

foundation::Result<SceneTerrain> openScene(const std::filesystem::path& file, const TerrainRequest& request)
{
    if (isTerrainFile(file)) return openElevation(file, request);
    const auto model = readModel(file, "give a .roam file, an elevation raster or a model");
    if (model)
    {
        TerrainFinder finder;
        model->node->accept(finder);
        SceneTerrain scene{model->node, finder.found, nullptr};
        scene.notes = model->notes;
        return scene;
    }
    // GDAL reads rasters with many suffixes, some of which are also those of models (.flt, .dem).
    auto terrain = openElevation(file, request);
    if (terrain) return terrain;
    const std::string suffix = osgDB::getLowerCaseFileExtension(file.string());
    const bool isModel = osgDB::Registry::instance()->getReaderWriterForExtension(suffix) != nullptr;
    return isModel ? model.error() : terrain.error();
}

} // namespace trainer
