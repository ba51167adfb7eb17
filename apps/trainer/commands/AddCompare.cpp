// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "actions/CompareCommand.h"
#include "commands/Commands.h"
#include "commands/PlayOptions.h"
#include "terminal/CommandLine.h"

namespace trainer
{

std::vector<Command> addCompare(CLI::App& program)
{
    const auto request = std::make_shared<CompareRequest>();
    CLI::App* command = program.add_subcommand("compare", "compare two tables of motion");
    command->add_option("TABLE", request->table, "motion to judge, from --csv_logger")->required();
    command->add_option("REFERENCE", request->reference, "motion to judge it by; may be compressed by gzip")
        ->required();
    command->add_option("--position", request->limits.positionM, "largest difference in metres")
        ->check(terminal::between(0.0, 1e9));
    command->add_option("--heading", request->limits.headingDeg, "largest difference in degrees")
        ->check(terminal::between(0.0, 360.0));
    command->add_option("--json", request->jsonFile, "file for the differences");
    return {{command, [request] { return exitCodeOf(compare(*request)); }}};
}

} // namespace trainer
