// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include <viewlod/Result.h>

#include "terminal/CommandLine.h"
#include "terminal/Report.h"

namespace pmtool
{

/// What the command line asked for. Each add…() declares one subcommand with its options, which live in its callback; the
/// one that is chosen puts its work here.
struct Chosen
{
    std::function<viewlod::Result<terminal::Report>()> work;
    std::filesystem::path jsonFile;
};

/// `compare`, to which the comparisons are added.
CLI::App* addCompareGroup(CLI::App& app);

} // namespace pmtool
