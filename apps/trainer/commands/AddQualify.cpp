// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "actions/QualifyCommand.h"
#include "actions/QualifyLightCommand.h"
#include "commands/Commands.h"
#include "terminal/CommandLine.h"

namespace trainer
{

/// `qualify` has a command below it for each kind of vehicle, and one for light.
std::vector<Command> addQualify(CLI::App& program)
{
    const auto request = std::make_shared<QualifyRequest>();
    const auto ofDrive = std::make_shared<QualifyDriveRequest>();
    CLI::App* qualify =
        program.add_subcommand("qualify", "hold vehicles and light against what is known of them");
    qualify->require_subcommand(1);
    CLI::App* flight =
        qualify->add_subcommand("flight", "fly an aircraft against its handbook and recorded flights");
    flight->add_option("--aircraft", request->aircraft, "aircraft file");
    flight->add_option("--json", request->jsonFile, "JSON file for the figures");
    CLI::App* drive = qualify->add_subcommand("drive", "drive road vehicles against figures and models");
    drive->add_option("--vehicle", ofDrive->vehicles, "road vehicle files");
    drive->add_option("--stand", ofDrive->standsS, "seconds to stand on a slope")
        ->check(terminal::between(1.0, 86400.0));
    drive->add_option("--json", ofDrive->jsonFile, "JSON file for the figures");
    const auto ofLight = std::make_shared<QualifyLightRequest>();
    CLI::App* light = qualify->add_subcommand(
        "light", "measure air, sky, lamps and clouds as they are drawn; fails when a figure fails");
    light->add_option("--json", ofLight->jsonFile, "JSON file for the figures");
    return {{flight, [request] { return qualifyFlight(*request); }},
            {drive, [ofDrive] { return qualifyDrive(*ofDrive); }},
            {light, [ofLight] { return qualifyLight(*ofLight); }}};
}

} // namespace trainer
