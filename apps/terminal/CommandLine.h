// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <CLI/CLI.hpp>

namespace terminal
{

/// Reads the command line. A returned value is the exit code with which the program must end: --help or --version has
/// been printed, or one line on stderr that names the fault and where to look it up.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// Accepts finite numbers from `least` to `most`. (CLI::Range accepts NaN.)
CLI::Validator between(double least, double most);

} // namespace terminal
