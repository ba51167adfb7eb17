// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

namespace pmtool
{

/// Runs a program to its end and writes both its outputs to `outputFile`. Errors: it cannot be started, was
/// not done after `seconds` (then it is killed), died of a signal, or returned another code than 0.
foundation::Outcome runProgram(const std::vector<std::string>& command,
                               const std::filesystem::path& outputFile, double seconds);

} // namespace pmtool
