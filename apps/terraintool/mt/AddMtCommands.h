// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "terraintool/RunCommand.h"
#include "terraintool/mt/MtRequest.h"

namespace CLI
{
class App;
}

namespace terraintool
{

/// Declares the options of mt-build but for its threads.
void addMtBuildOptions(CLI::App& app, MtBuildRequest& request, std::filesystem::path& jsonFile);

/// Declares `mt-build`; `mt-plan`, `mt-job` and `mt-join`; `mt-extract`; `mt-fly`. When one is asked for,
/// `command` does it.
void addMtBuild(CLI::App& app, std::filesystem::path& jsonFile, Command& command);
void addMtJobs(CLI::App& app, std::filesystem::path& jsonFile, Command& command);
void addMtExtract(CLI::App& app, std::filesystem::path& jsonFile, Command& command);
void addMtFly(CLI::App& app, std::filesystem::path& jsonFile, Command& command);

} // namespace terraintool
