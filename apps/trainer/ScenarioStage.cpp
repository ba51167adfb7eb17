// SPDX-License-Identifier: Apache-2.0
#include "ScenarioStage.h"

#include <iostream>

#include <glm/geometric.hpp>

#include "FlatScene.h"
#include "ScenarioPlace.h"
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
    std::filesystem::path roads = simulation::roadsFile(scenario, folder);
    if (namesScene && !roads.empty())
        std::cout << "note: " << network.sceneGraphFile
                  << " is not there; the roads are shown on ground of their own\n";
    return roads;
}

/// Where Init names no place on earth, level ground needs some place there.
constexpr simulation::Geodetic kSomewhere{46.0, 8.0, 0.0};
// Coordinates of a map (UTM) are hundreds of kilometres from their origin; the ground reaches 20 km.
constexpr double kFarM = 10e3;

foundation::Result<SceneTerrain> levelStage(const simulation::Scenario& scenario)
{
    const std::string& roads = scenario.roadNetwork.logicFile;
    std::cout << "note: "
              << (roads.empty() ? "RoadNetwork names neither SceneGraphFile nor LogicFile"
                                : "the LogicFile " + roads + " is not there")
              << "; entities move over level ground (--terrain FILE gives another)\n";
    const std::optional<simulation::Geodetic> onEarth = placeOnEarth(scenario);
    const glm::dvec3 start = startInWorld(scenario).value_or(glm::dvec3(0.0));
    simulation::Geodetic middle = onEarth.value_or(kSomewhere);
    middle.heightM = start.z;
    auto scene = makeLevelScene(middle);
    const bool isFar = !onEarth && glm::length(glm::dvec2(start)) > kFarM;
    return scene && isFar ? moved(std::move(*scene), start) : scene;
}

} // namespace

foundation::Result<SceneTerrain> openStage(const simulation::Scenario& scenario, const PlayRequest& request)
{
    const std::filesystem::path file = sceneFileOf(scenario, request);
    if (file.empty()) return levelStage(scenario);
    TerrainRequest scene = request.terrain;
    scene.inRoadsFrame = true;
    return openScene(file, scene);
}

} // namespace trainer
