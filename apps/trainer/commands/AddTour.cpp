// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "PlayCommand.h"
#include "commands/Commands.h"
#include "commands/PlayOptions.h"

namespace trainer
{

namespace
{

struct TourLine
{
    PlayOptions play;
    std::filesystem::path saveFile;
    double durationS = 20.0;
};

} // namespace

std::vector<Command> addTour(CLI::App& program)
{
    const auto line = std::make_shared<TourLine>();
    CLI::App* command =
        program.add_subcommand("tour", "fly over an elevation file, or drive through a road network");
    command
        ->add_option("DEM", line->play.request.terrain.file,
                     "any elevation raster, a .roam file, or an OpenDRIVE network (.xodr)")
        ->required();
    command->add_option("--save", line->saveFile, "file for the scenario that is played");
    command->add_option("--duration", line->durationS, "seconds")->check(terminal::between(4.0, 3600.0));
    line->play.addTo(*command);
    return {{command, line->play.running(
                          [line] { return tour(line->play.request, line->saveFile, line->durationS); })}};
}

} // namespace trainer
