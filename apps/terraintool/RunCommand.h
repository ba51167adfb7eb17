// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include "terraintool/Commands.h"

namespace terraintool
{

using Command = std::function<foundation::Result<Report>(const Request&)>;

/// Runs a command, writes its table to `jsonFile` unless that is empty, and returns the exit code of the
/// program: kFailed after an error, and when the table contains a failed check.
int run(const Command& command, const Request& request, const std::filesystem::path& jsonFile);

} // namespace terraintool
