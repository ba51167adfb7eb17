// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/ScenarioRoads.h"

namespace simulation
{

foundation::Result<std::shared_ptr<const RoadScene>> openRoads(const Scenario& scenario,
                                                               const std::filesystem::path& folder)
{
    const std::string& file = scenario.roadNetwork.logicFile;
    if (file.empty()) return std::shared_ptr<const RoadScene>();
    return RoadScene::open(folder / file);
}

} // namespace simulation
