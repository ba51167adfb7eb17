// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace simulation
{

/// Returns the file or folder that a scenario names. Its path counts from the scenario's folder; where
/// nothing is, the last part of it is looked for there, then the path from where the program runs, as esmini
/// does. Nowhere: the first of these. Backslashes part folders, too: authors on Windows write them.
std::filesystem::path namedFile(const std::filesystem::path& folder, std::string name);

} // namespace simulation
