// SPDX-License-Identifier: Apache-2.0
// trainer: plays scenarios over terrain and writes images of them.
#include <vector>

#include <foundation/HugeHeap.h>

#include <osgOffscreen/OpenGlVersion>

#include "commands/Commands.h"
#include "terminal/CommandLine.h"
#include "terminal/Guard.h"
#include "terminal/Terminal.h"

namespace
{

int run(int argc, char** argv)
{
    CLI::App program("Plays driving and flight scenarios over terrain, offscreen, the same way every time.",
                     "trainer");
    program.set_version_flag("--version", OSGTRAINER_VERSION);
    program.footer(
        "Needs OpenGL " + osgOffscreen::kEverythingNeeds.text() +
        " in the compatibility profile, from a driver of the machine (--backend egl) or from Mesa's OSMesa.");
    program.require_subcommand(1);
    std::vector<trainer::Command> commands;
    for (const trainer::AddCommand add : trainer::kCommands)
        for (trainer::Command& command : add(program))
            commands.push_back(std::move(command));
    if (const auto ends = terminal::parse(program, argc, argv)) return *ends;
    for (const trainer::Command& command : commands)
        if (*command.line) return command.run();
    return terminal::kWrongUse; // not reached: require_subcommand
}

} // namespace

int main(int argc, char** argv)
{
    foundation::growHeapInHugePages();
    return terminal::guarded("trainer", [=] { return run(argc, argv); });
}
