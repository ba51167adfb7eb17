// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace trainer
{

/// The arguments of `trainer qualify flight`.
struct QualifyRequest
{
    std::filesystem::path aircraft = "data/aircraft/c172p.xml";
    std::filesystem::path jsonFile; ///< empty: none
};

/// Flies an aircraft against its handbook and, where OSGTRAINER_REAL_DATA names the folder of real data, against recorded flights; prints
/// one line for each figure, writes them as JSON, and returns the exit code of the program: terminal::kFailed after an error and when a
/// figure fails.
int qualifyFlight(const QualifyRequest& request);

} // namespace trainer
