// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "actions/DevicesCommand.h"
#include "commands/Commands.h"
#include "commands/PlayOptions.h"
#include "terminal/CommandLine.h"

namespace trainer
{

std::vector<Command> addDevices(CLI::App& program)
{
    const auto request = std::make_shared<DevicesRequest>();
    CLI::App* command = program.add_subcommand("devices", "list joysticks, yokes, pedals and wheels");
    command->add_option("--live", request->liveS, "seconds to show their axes and buttons as they move")
        ->check(terminal::between(0.0, 1e5));
    command->add_option("--devices", request->devicesFile, "devices file to tell what each is for");
    return {{command, [request] { return exitCodeOf(listDevices(*request)); }}};
}

} // namespace trainer
