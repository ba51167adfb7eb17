// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "terminal/CommandLine.h"
#include "terraintool/RunCommand.h"
#include "terraintool/mt/MtRequest.h"

namespace terraintool
{

/// Declares `mt-build`, `mt-bench` and `mt-fly`. When one is asked for, `command` does it.
void addMtBuild(CLI::App& app, std::filesystem::path& jsonFile, Command& command);
void addMtBench(CLI::App& app, std::filesystem::path& jsonFile, Command& command);
void addMtFly(CLI::App& app, std::filesystem::path& jsonFile, Command& command);

} // namespace terraintool
