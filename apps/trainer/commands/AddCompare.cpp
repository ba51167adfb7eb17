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
    CLI::Option* const position = command->add_option(
        "--position", request->limits.positionM, "largest difference in metres; beyond it the command fails");
    position->check(terminal::between(0.0, 1e9));
    CLI::Option* const heading =
        command->add_option("--heading", request->limits.headingDeg,
                            "largest difference in degrees; beyond it the command fails");
    heading->check(terminal::between(0.0, 360.0));
    command->add_flag("--fail-beyond", request->failsBeyond,
                      "fails beyond the limits, 0.05 m and 0.1 degrees where none is given");
    command->add_option("--json", request->jsonFile, "file for the differences");
    return {{command, [request, position, heading]
             {
                 request->failsBeyond = request->failsBeyond || *position || *heading;
                 return exitCodeOf(compare(*request));
             }}};
}

} // namespace trainer
