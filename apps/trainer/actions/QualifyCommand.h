// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include <foundation/DataFile.h>

namespace trainer
{

/// The arguments of `trainer qualify flight`.
struct QualifyRequest
{
    std::filesystem::path aircraft = foundation::dataFile("aircraft/c172p.xml");
    std::filesystem::path jsonFile; ///< empty: none
};

/// Flies an aircraft against its handbook and, where OSGTRAINER_REAL_DATA names the folder of real data,
/// against recorded flights; prints one line for each figure, writes them as JSON, and returns the exit code
/// of the program: terminal::kFailed after an error and when a figure fails.
int qualifyFlight(const QualifyRequest& request);

/// The arguments of `trainer qualify drive`.
struct QualifyDriveRequest
{
    std::vector<std::filesystem::path> vehicles{foundation::dataFile("vehicles/car.xml"),
                                                foundation::dataFile("vehicles/van.xml"),
                                                foundation::dataFile("vehicles/bus.xml")};
    double standsS = 3600.0;        ///< on a slope
    std::filesystem::path jsonFile; ///< empty: none
};

/// Drives road vehicles against the figures of their files, the single-track model, the friction of their
/// tyres, a slope and a kerb; prints, writes and returns as qualifyFlight().
int qualifyDrive(const QualifyDriveRequest& request);

} // namespace trainer
