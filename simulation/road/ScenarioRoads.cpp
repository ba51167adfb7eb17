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

std::optional<foundation::Error> missingRoads(const Scenario& scenario, const std::filesystem::path& folder)
{
    const std::string& name = scenario.roadNetwork.logicFile;
    if (name.empty() || !roadsFile(scenario, folder).empty()) return std::nullopt;
    return foundation::Error{(folder / name).string(), "the LogicFile is not there",
                             "instead: there are no roads; correct its path"};
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
