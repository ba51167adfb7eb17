// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <CLI/CLI.hpp>

namespace terminal
{

/// Reads the command line. A value: the program ends with this exit code; --help or --version has been printed, or the
/// one line on stderr that says what makes no sense and where to look it up.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// Accepts finite numbers from `least` to `most`. CLI::Range lets NaN pass.
CLI::Validator between(double least, double most);

} // namespace terminal
