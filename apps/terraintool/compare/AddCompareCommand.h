// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "terminal/CommandLine.h"
#include "terraintool/RunCommand.h"

namespace terraintool
{

/// Declares `compare`. When it is asked for, `command` does it.
void addCompare(CLI::App& app, std::filesystem::path& jsonFile, Command& command);

} // namespace terraintool
