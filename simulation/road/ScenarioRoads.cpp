// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/ScenarioRoads.h"

#include <osgRoads/core/query/GeoReference.h>

#include "simulation/scenario/NamedFile.h"

namespace simulation
{

std::filesystem::path roadsFile(const Scenario& scenario, const std::filesystem::path& folder)
{
    const std::string& name = scenario.roadNetwork.logicFile;
    if (name.empty()) return {};
    std::error_code ignored;
    for (const char* extension : {"", ".xodr"})
        if (const auto file = namedFile(folder, name + extension);
            std::filesystem::is_regular_file(file, ignored))
            return file;
    return {};
}

namespace
{

foundation::Error notThere(const std::filesystem::path& file, SourceLine line, const std::string& element,
                           const std::string& name, const std::string& remedy)
{
    return {file.string() + ":" + std::to_string(line.line), "the " + element + " " + name + " is not there",
            remedy};
}

/// Whether a LogicFile is no path but the name of a map that another program brings along: `Town01`.
bool isTown(const std::string& name)
{
    return name.find_first_of("./\\") == std::string::npos;
}

} // namespace

foundation::Result<MissingFiles> missingFiles(const Scenario& scenario, const std::filesystem::path& file,
                                              WithoutRoads without)
{
    MissingFiles missing;
    const RoadNetwork& network = scenario.roadNetwork;
    const std::filesystem::path folder = file.parent_path();
    if (!network.logicFile.empty() && roadsFile(scenario, folder).empty())
    {
        if (without == WithoutRoads::refused && !isTown(network.logicFile))
            return notThere(file, network.logicLine, "LogicFile", network.logicFile,
                            "correct its path, or play without roads (--without-roads)");
        missing.roads = notThere(file, network.logicLine, "LogicFile", network.logicFile,
                                 "instead: there are no roads; correct its path");
    }
    std::error_code ignored;
    if (!network.sceneGraphFile.empty() && !std::filesystem::exists(folder / network.sceneGraphFile, ignored))
        missing.scene = notThere(file, network.sceneLine, "SceneGraphFile", network.sceneGraphFile,
                                 network.logicFile.empty() ? "pictures need it; correct its path"
                                 : missing.roads           ? "instead: level ground; correct its path"
                                                 : "instead: ground of the roads' own; correct its path");
    return missing;
}

foundation::Result<std::shared_ptr<const RoadScene>> openRoads(const Scenario& scenario,
                                                               const std::filesystem::path& folder)
{
    const std::filesystem::path file = roadsFile(scenario, folder);
    if (file.empty()) return std::shared_ptr<const RoadScene>();
    return RoadScene::open(file);
}

std::function<std::optional<glm::dvec3>(const Geodetic&)> projectionOf(const RoadScene& roads)
{
    auto created = osgRoads::core::GeoReference::create(roads.network().header, "the road network");
    if (!created) return {};
    auto reference = std::make_shared<const osgRoads::core::GeoReference>(std::move(*created));
    return [reference](const Geodetic& place) -> std::optional<glm::dvec3>
    {
        const auto inertial = reference->toInertial({place.latitudeDeg, place.longitudeDeg, place.heightM});
        return inertial ? std::optional(*inertial) : std::nullopt;
    };
}

} // namespace simulation
