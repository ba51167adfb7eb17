// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace simulation
{

/// A further input of a JSBSim aircraft, besides those that every aircraft has (an autopilot's switch, a gear
/// lever).
struct JsbsimInput
{
    std::string name;     ///< in inputs files
    std::string property; ///< of JSBSim
};

/// An aircraft of JSBSim, and how JSBSim is reached.
struct JsbsimData
{
    std::string name;                         ///< for people
    std::filesystem::path program = "JSBSim"; ///< a path, or a name that PATH finds
    std::filesystem::path root;               ///< the folder with aircraft/, engine/, systems/
    std::string aircraft;                     ///< the name of a folder of aircraft/
    std::vector<JsbsimInput> inputs{};
    double answersWithinS = 5.0; ///< of real time, for a step
    double beginsWithinS = 20.0; ///< of real time, from its start to its first answer
};

} // namespace simulation
