// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace simulation
{

/// A recorded simulation: a column-wise table from a gzipped CSV whose header names each entity's columns as
/// `#1 World_Position_X [m]`.
struct SimulatedTrack
{
    std::vector<double> timeS;

    /// By entity (1 …) and column name without unit: World_Position_X.
    std::map<std::pair<int, std::string>, std::vector<double>> columns;

    const std::vector<double>& column(int entity, const std::string& name) const
    {
        return columns.at({entity, name});
    }
};

SimulatedTrack readSimulatedTrack(const std::filesystem::path& file);

/// The folder of real data, from OSGTRAINER_REAL_DATA; nothing when the variable is unset.
inline std::optional<std::filesystem::path> realData()
{
    const char* const folder = std::getenv("OSGTRAINER_REAL_DATA");
    if (!folder || !*folder) return std::nullopt;
    return std::filesystem::path(folder);
}

} // namespace simulation
