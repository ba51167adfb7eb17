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
std::filesystem::path sceneFileOf(const simulation::Scenario& scenario, const PlayRequest& request,
                                  std::vector<std::string>& notes)
{
    if (!request.terrain.file.empty()) return request.terrain.file;
    const simulation::RoadNetwork& network = scenario.roadNetwork;
    const bool namesScene = !network.sceneGraphFile.empty(), namesRoads = !network.logicFile.empty();
    const std::filesystem::path folder = request.scenario.parent_path();
    const std::filesystem::path scene = folder / network.sceneGraphFile;
    std::error_code ignored;
    if (namesScene && (!namesRoads || std::filesystem::exists(scene, ignored))) return scene;
    std::filesystem::path roads = simulation::roadsFile(scenario, folder);
    if (namesScene && !roads.empty())
        notes.push_back(network.sceneGraphFile + " is not there; the roads are shown on ground of their own");
    return roads;
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
    const std::string& roads = scenario.roadNetwork.logicFile;
    const std::string reason = roads.empty() ? "RoadNetwork names neither SceneGraphFile nor LogicFile"
                                             : "the LogicFile " + roads + " is not there";
    scene->notes.push_back(reason + "; entities move over level ground (--terrain FILE gives another)");
    const bool isFar = !onEarth && glm::length(glm::dvec2(start)) > kFarStartM;
    return isFar ? moved(std::move(*scene), start) : scene;
}

} // namespace

foundation::Result<SceneTerrain> openStage(const simulation::Scenario& scenario, const PlayRequest& request)
{
    std::vector<std::string> notes;
    const std::filesystem::path file = sceneFileOf(scenario, request, notes);
    if (file.empty()) return levelStage(scenario);
    TerrainRequest scene = request.terrain;
    scene.inRoadsFrame = true;
    auto opened = openScene(file, scene);
    if (opened) opened->notes.insert(opened->notes.begin(), notes.begin(), notes.end());
    return opened;
}

} // namespace trainer
