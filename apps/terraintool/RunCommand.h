// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include "terraintool/Commands.h"

namespace terraintool
{

using Command = std::function<foundation::Result<Report>(const Request&)>;

/// Carries a command out, writes its table to `jsonFile` unless that is empty, and returns the program's exit code:
/// kFailed after an error, and when the table says that something is not as it must be.
int run(const Command& command, const Request& request, const std::filesystem::path& jsonFile);

} // namespace terraintool
