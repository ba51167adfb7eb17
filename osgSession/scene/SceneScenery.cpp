// SPDX-License-Identifier: Apache-2.0
#include "SceneScenery.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include <osgDB/FileNameUtils>
#include <osgDB/Registry>

#include "SceneryWays.h"
#include "scenery/placement/ReadScenery.h"

namespace trainer
{

namespace
{

using scenery::SceneryDescription;

constexpr double kLeastS =
    600.0; ///< least time that is played to find the paths: fewer frames give the same scenery
constexpr std::size_t kMostModels = 64;
constexpr double kFolderDensityPerKm2 = 250.0, kFolderNearM = 8.0, kFolderFarM = 900.0;

bool isModel(const std::filesystem::path& file)
{
    const std::string suffix = osgDB::getLowerCaseFileExtension(file.string());
    static constexpr std::array kModels{"pm",  "ac",  "osg", "osgt", "osgb", "osgx", "ive",  "obj",
                                        "3ds", "flt", "lwo", "dae",  "stl",  "ply",  "gltf", "glb"};
    return std::find(kModels.begin(), kModels.end(), suffix) != kModels.end();
}

/// Adds a field with the models of a folder, sorted by name.
foundation::Outcome addFolder(const std::filesystem::path& folder, SceneryDescription& description)
{
    scenery::SceneryField field;
    field.name = "--objects " + folder.string();
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
        if (entry.is_regular_file(failed) && isModel(entry.path()))
            field.objects.push_back({{}, 0, entry.path().string()});
    if (field.objects.empty())
        return foundation::Error{folder.string(), "has no model that OpenSceneGraph reads",
                                 "give a folder of .pm, .osgb, .obj, .ac … files"};
    std::sort(field.objects.begin(), field.objects.end(),
              [](const auto& a, const auto& b) { return a.file < b.file; });
    field.objects.resize(std::min(field.objects.size(), kMostModels));
    field.densityPerKm2 = kFolderDensityPerKm2;
    field.where.pathDistanceM = scenery::Span{kFolderNearM, kFolderFarM};
    description.fields.push_back(field);
    return foundation::success();
}

foundation::Result<SceneryDescription> descriptionOf(const SceneryRequest& request)
{
    SceneryDescription description;
    if (!request.description.empty())
    {
        auto read = scenery::readScenery(request.description);
        if (!read) return read.error();
        description = *std::move(read);
    }
    if (!request.modelsFolder.empty())
        if (const auto added = addFolder(request.modelsFolder, description); !added) return added.error();
    return description;
}

scenery::Ground groundOf(const SceneTerrain& terrain)
{
    scenery::Ground ground;
    ground.heightM = terrain.ground().heights();
    ground.elevationM = [tile = terrain.terrain->tile()](double eastM, double northM, double heightM) {
        return tile->tile.frame().heightOf({eastM, northM, heightM});
    };
    ground.seaLevelM = terrain.terrain->material()->climate().seaLevelM;
    return ground;
}

void report(const scenery::PlacedScenery& placed, const scenery::SceneryShapes& shapes, double placingS,
            std::vector<std::string>& notes)
{
    char text[160];
    std::snprintf(text, sizeof text,
                  "scenery: %zu objects placed in %.2f s, levels of %zu models made in %.1f s",
                  placed.placements.size(), placingS, shapes.shapes.size(), shapes.seconds);
    notes.emplace_back(text);
    for (const scenery::FieldReport& field : placed.reports)
        if (field.placed < field.wanted)
            notes.push_back("scenery: " + field.name + ": room for " + std::to_string(field.placed) + " of " +
                            std::to_string(field.wanted));
}

/// Reports rules for land cover, which the trainer cannot test.
void reportUnheeded(const scenery::SceneryDescription& description, std::vector<std::string>& notes)
{
    for (const scenery::SceneryField& field : description.fields)
        if (!field.where.covers.empty())
            notes.push_back("scenery: " + field.name +
                            ": 'covers' is ignored, objects stand on any land cover");
}

} // namespace

ObjectFigures SceneScenery::figures(unsigned int frameNumber) const
{
    ObjectFigures figures;
    for (const osgPMObjects::FieldViewStatistics& group : node.field->statistics())
    {
        if (group.frame != frameNumber) continue; // an eye that has gone
        figures.visible += group.visible;
        figures.drawn += group.drawn;
        figures.switching += group.switching;
        figures.triangles += group.triangles;
        figures.cullMs += group.cullMs;
        for (std::size_t i = 0; i < osgPMObjects::core::kSelectionMethods; ++i)
            figures.selection.byMethod[i] += group.selection.byMethod[i];
        figures.selection.budget = group.selection.budget;
    }
    return figures;
}

foundation::Outcome checkScenery(const SceneryRequest& request)
{
    const auto description = descriptionOf(request);
    return description ? foundation::success() : description.error();
}

foundation::Result<std::optional<SceneScenery>> makeScenery(const SceneryRequest& request, double playS,
                                                            const simulation::Scenario& scenario,
                                                            const simulation::PlayerOptions& options,
                                                            const SceneTerrain& terrain)
{
    if (request.isEmpty()) return std::optional<SceneScenery>();
    const auto description = descriptionOf(request);
    if (!description) return description.error();
    const std::string place = request.name();
    if (!terrain.terrain || terrain.cornerM != glm::dvec2(0.0))
        return foundation::Error{place, "needs a terrain whose ground can be asked",
                                 "play over an elevation raster or a .roam file"};
    const auto shapes = scenery::makeSceneryShapes(scenery::objectsOf(*description));
    if (!shapes) return shapes.error();
    scenery::Ways ways = waysOf(scenario, options, std::max(kLeastS, playS));
    if (terrain.roads) keepRoadsClear(*terrain.roads, ways);
    const auto begin = std::chrono::steady_clock::now();
    scenery::PlacedScenery placed =
        scenery::placeScenery(*description, shapes->measures, groundOf(terrain), ways);
    const double placingS = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::optional<SceneScenery> made(std::in_place);
    made->occluders = scenery::occludersOf(*description, placed, shapes->measures);
    report(placed, *shapes, placingS, made->notes);
    reportUnheeded(*description, made->notes);
    auto node = scenery::makeSceneryNode(*description, std::move(placed.placements), *shapes, place);
    if (!node) return node.error();
    made->node = *std::move(node);
    made->fullBudget = made->node.field->budget();
    return made;
}

} // namespace trainer
