// SPDX-License-Identifier: Apache-2.0
#include "ScenarioStage.h"

#include <glm/geometric.hpp>

#include "FlatScene.h"
#include "osgSession/src/core/ScenarioPlace.h"
#include "simulation/road/ScenarioRoads.h"

namespace trainer
{

namespace
{

/// A SceneGraphFile that is there comes before the LogicFile: storyboards of other programs often name models
/// that are not kept.
/// Empty: there is neither.
std::filesystem::path sceneFileOf(const simulation::Scenario& scenario, const PlayRequest& request)
{
    if (!request.terrain.file.empty()) return request.terrain.file;
    const simulation::RoadNetwork& network = scenario.roadNetwork;
    const bool namesScene = !network.sceneGraphFile.empty(), namesRoads = !network.logicFile.empty();
    const std::filesystem::path folder = request.scenario.parent_path();
    const std::filesystem::path scene = folder / network.sceneGraphFile;
    std::error_code ignored;
    if (namesScene && (!namesRoads || std::filesystem::exists(scene, ignored))) return scene;
    return simulation::roadsFile(scenario, folder);
}

/// Where Init names no place on earth, level ground needs some place there.
constexpr simulation::Geodetic kSomewhere{46.0, 8.0, 0.0};
// Coordinates of a map (UTM) are hundreds of kilometres from their origin; the ground reaches 20 km.
constexpr double kFarStartM = 10e3;

foundation::Result<SceneTerrain> levelStage(const simulation::Scenario& scenario)
{
    const std::optional<simulation::Geodetic> onEarth = placeOnEarth(scenario);
    const glm::dvec3 start = startInWorld(scenario).value_or(glm::dvec3(0.0));
    simulation::Geodetic middle = onEarth.value_or(kSomewhere);
    middle.heightM = start.z;
    auto scene = makeLevelScene(middle);
    if (!scene) return scene;
    const bool namesRoads = !scenario.roadNetwork.logicFile.empty();
    const std::string reason =
        namesRoads ? "there are no roads" : "RoadNetwork names neither SceneGraphFile nor LogicFile";
    scene->notes.push_back(reason + "; entities move over level ground (--terrain FILE gives another)");
    const bool isFar = !onEarth && glm::length(glm::dvec2(start)) > kFarStartM;
    return isFar ? moved(std::move(*scene), start) : scene;
}

} // namespace

foundation::Result<SceneTerrain> openStage(const simulation::Scenario& scenario, const PlayRequest& request)
{
    const bool hasOther = !request.terrain.file.empty();
    const auto missing = simulation::missingFiles(
        scenario, request.scenario, hasOther ? simulation::WithoutRoads::played : request.without);
    if (!missing) return missing.error();
    const std::filesystem::path file = sceneFileOf(scenario, request);
    TerrainRequest scene = request.terrain;
    scene.inRoadsFrame = true;
    auto opened = file.empty() ? levelStage(scenario) : openScene(file, scene);
    if (!opened) return opened;
    std::vector<std::string>& notes = opened->notes;
    if (missing->scene && !hasOther) notes.insert(notes.begin(), missing->scene->message());
    if (missing->roads) notes.insert(notes.begin(), missing->roads->message());
    return opened;
}

} // namespace trainer
