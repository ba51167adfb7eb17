// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include <foundation/WholeFile.h>

#include <osgTerrainROAM/core/method/Method.h>

#include "actions/PlayCommand.h"
#include "commands/Commands.h"
#include "commands/PlayOptions.h"
#include "scene/SceneTerrain.h"
#include "terminal/CommandLine.h"
#include "world/WorldFiles.h"

namespace trainer
{

namespace
{

struct TourLine
{
    PlayOptions play;
    std::filesystem::path saveFile;
    double durationS = 20.0;
    WorldChoice world;
};

/// Whether a world can be shown: its roads and waters lie between the samples of the raster, which not every
/// method takes.
bool takesWorld(const PlayRequest& request)
{
    using namespace osgTerrainROAM::core;
    if (!request.terrain.method || traitsOf(*request.terrain.method).hasFineSamples) return true;
    std::cerr
        << "note: " << methodName(*request.terrain.method)
        << " takes no samples between those of the raster, as roads need; the elevation is shown alone\n";
    return false;
}

/// Where files say what stands on the elevation, no world is made up over it.
foundation::Outcome tourOne(const TourLine& line)
{
    if (const auto writable = foundation::checkWritable(line.saveFile); !writable) return writable;
    PlayRequest request = line.play.request;
    if (const auto sound = checkElevation(request.terrain.file, request.terrain); !sound) return sound;
    if (!line.world.isLeftOut && request.scenery.isEmpty() && takesWorld(request))
        if (const auto world = worldOver(request.terrain.file, line.world.folder))
            request.terrain.file = *world;
    return tour(request, line.saveFile, line.durationS);
}

} // namespace

std::vector<Command> addTour(CLI::App& program)
{
    const auto line = std::make_shared<TourLine>();
    CLI::App* command =
        program.add_subcommand("tour", "fly over an elevation file, or drive through a road network");
    command
        ->add_option("DEM", line->play.request.terrain.file,
                     "any elevation raster, a .roam file, a multi-triangulation (.mt), or an OpenDRIVE "
                     "network (.xodr)")
        ->required();
    command->add_option("--save", line->saveFile, "file for the scenario that is played");
    command->add_option("--duration", line->durationS, "seconds")->check(terminal::between(4.0, 3600.0));
    CLI::Option* const leftOut = command->add_flag(
        "--no-world", line->world.isLeftOut, "the elevation alone, without a world that is made up over it");
    command
        ->add_option("--world-folder", line->world.folder,
                     "folder of the world that is made up over a raster, instead of one in ~/.cache")
        ->excludes(leftOut);
    line->play.addTo(*command);
    return {{command, line->play.running([line] { return tourOne(*line); })}};
}

} // namespace trainer
