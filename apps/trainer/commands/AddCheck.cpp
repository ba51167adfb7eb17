// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "actions/CheckCommand.h"
#include "commands/Commands.h"
#include "terminal/CommandLine.h"

namespace trainer
{

std::vector<Command> addCheck(CLI::App& program)
{
    const auto request = std::make_shared<CheckRequest>();
    CLI::App* check = program.add_subcommand("check", "list everything wrong or not in effect in scenarios");
    CLI::Option* const files =
        check->add_option("SCENARIO", request->scenarios, "OpenSCENARIO XML, one file or several");
    check->add_flag("--strict", request->isStrict, "exit code 1 also for what is not in effect");
    check->add_option("--json", request->jsonFile, "file for the findings and the elements of each file");
    check
        ->add_flag("--coverage", request->printsCoverage,
                   "print what becomes of every element of the standard")
        ->excludes(files);
    return {{check, [request] { return trainer::check(*request); }}};
}

} // namespace trainer
