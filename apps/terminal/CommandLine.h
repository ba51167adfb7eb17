// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace terminal
{

/// Reads the command line. A returned value is the exit code with which the program must end: --help or
/// --version has been printed, or one line on stderr that names the fault and where to look it up.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// Accepts finite numbers from `least` to `most`. (CLI::Range accepts NaN.)
CLI::Validator between(double least, double most);

/// Accepts file names with this extension: ".pm".
CLI::Validator extension(const std::string& dotted);

/// Accepts the names of a table, and gives the option the value of the name. (CLI::CheckedTransformer prints
/// its numbers.)
template<class Value>
CLI::Validator named(const std::map<std::string, Value>& values)
{
    std::string names;
    for (const auto& [name, value] : values)
        names += (names.empty() ? "" : ", ") + name;
    const auto transform = [values, names](std::string& text)
    {
        const auto found = values.find(text);
        if (found == values.end()) return "'" + text + "' is none of " + names;
        text = std::to_string(static_cast<long long>(found->second));
        return std::string();
    };
    return CLI::Validator(transform, names);
}

} // namespace terminal
