// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace trainer
{

/// The arguments of `trainer qualify light`.
struct QualifyLightRequest
{
    std::filesystem::path jsonFile; ///< empty: none
};

/// Measures air, sky, lamps and clouds as they are drawn, against laws and oracles; prints a line for each
/// figure and for each goal that has none, writes them as JSON, and returns the exit code of the program:
/// terminal::kFailed after an error (no offscreen context) and when a figure fails.
int qualifyLight(const QualifyLightRequest& request);

} // namespace trainer
