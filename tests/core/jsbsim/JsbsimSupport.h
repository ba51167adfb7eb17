// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cerrno>
#include <csignal>
#include <fstream>

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/jsbsim/JsbsimVehicle.h"

namespace testsupport
{

/// The Earth at 46 N 8 E, the scene's origin at sea level.
inline std::shared_ptr<const simulation::EarthFrame> earthOfJsbsim()
{
    return std::make_shared<const simulation::EarthFrame>(simulation::Geodetic{46.0, 8.0, 0.0});
}

/// The stand-in for JSBSim that behaves as `mode` says, with a root of its own in `folder`.
inline std::shared_ptr<simulation::JsbsimData> standIn(const std::string& mode,
                                                       const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder / "aircraft" / mode);
    std::ofstream(folder / "aircraft" / mode / (mode + ".xml")) << "<fdm_config/>\n";
    auto data = std::make_shared<simulation::JsbsimData>();
    data->name = data->aircraft = mode;
    data->root = folder;
    data->program = OSGTRAINER_JSBSIM_STAND_IN;
    data->answersWithinS = 0.5;
    data->beginsWithinS = 2.0;
    return data;
}

/// East at 50 m/s, 300 m above level ground.
inline simulation::VehicleStart eastwards()
{
    return {{0.0, 0.0, 300.0}, 0.0, 50.0, true};
}

/// Whether a process is there, a dead one that nobody has waited for among them.
inline bool isProcess(pid_t id)
{
    return kill(id, 0) == 0 || errno != ESRCH;
}

} // namespace testsupport
