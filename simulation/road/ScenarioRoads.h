// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "simulation/geodesy/LocalFrame.h"
#include "simulation/road/RoadScene.h"
#include "simulation/road/WithoutRoads.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// Returns the file that the LogicFile of a scenario names, as it is written or, for the bare name of a town,
/// with `.xodr`. Empty: it names none, or none is there. `folder`: of the scenario.
std::filesystem::path roadsFile(const Scenario& scenario, const std::filesystem::path& folder);

/// Files that RoadNetwork names and that are not there, as `file:line`, with what is done instead.
struct MissingFiles
{
    std::optional<foundation::Error> roads, scene;
};

/// Looks for the files that RoadNetwork names, before one of them is opened. `file`: of the scenario.
/// Errors: a LogicFile that is not there, as `without` says.
foundation::Result<MissingFiles> missingFiles(const Scenario& scenario, const std::filesystem::path& file,
                                              WithoutRoads without);

/// Opens the roads of roadsFile(); null: there are none.
/// Errors: as RoadScene::open().
foundation::Result<std::shared_ptr<const RoadScene>> openRoads(const Scenario& scenario,
                                                               const std::filesystem::path& folder);

/// The projection of a network with a georeference that PROJ knows; else empty.
std::function<std::optional<glm::dvec3>(const Geodetic&)> projectionOf(const RoadScene& roads);

} // namespace simulation
