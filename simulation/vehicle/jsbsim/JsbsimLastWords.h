// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace simulation
{

/// What JSBSim said of its end: of the file with what it printed, the last line that tells of an error, else
/// the last one; short.
std::string jsbsimLastWords(const std::filesystem::path& outputFile);

/// Whether it said that another program has its port.
bool jsbsimLostItsPort(const std::filesystem::path& outputFile);

} // namespace simulation
