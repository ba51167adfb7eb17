// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

namespace CLI
{
class App;
}

namespace trainer
{

/// A command of `trainer`: its place in the command line, and what it does once that is read.
struct Command
{
    const CLI::App* line;
    std::function<int()> run; ///< returns the exit code
};

/// Adds a command, or several, with their options to the program; a file for each.
using AddCommand = std::vector<Command> (*)(CLI::App& program);

std::vector<Command> addPlay(CLI::App& program);
std::vector<Command> addTour(CLI::App& program);
std::vector<Command> addCheck(CLI::App& program);
std::vector<Command> addCompare(CLI::App& program);
std::vector<Command> addFly(CLI::App& program);
std::vector<Command> addDrive(CLI::App& program);
std::vector<Command> addQualify(CLI::App& program);
std::vector<Command> addDevices(CLI::App& program);

/// The commands in the order of --help.
inline constexpr AddCommand kCommands[] = {addPlay, addTour,  addCheck,   addCompare,
                                           addFly,  addDrive, addQualify, addDevices};

} // namespace trainer
