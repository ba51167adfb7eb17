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

/// Becomes the program `qualify_light` beside this one, which measures light, prints and writes its figures,
/// and ends with terminal::kFailed after an error and when a figure fails; so the trainer links nothing that
/// measures. Returns, with the exit code, only when that program is not there.
int qualifyLight(const QualifyLightRequest& request);

} // namespace trainer
