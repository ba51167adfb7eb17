// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include <foundation/Result.h>

#include "terminal/Report.h"

namespace terraintool
{

/// The work that the command line of compare_terrain asked for. Each add…() declares one subcommand; the
/// callback of the chosen one sets `work`.
struct Chosen
{
    std::function<foundation::Result<terminal::Report>()> work;
    std::filesystem::path jsonFile;
};

} // namespace terraintool
