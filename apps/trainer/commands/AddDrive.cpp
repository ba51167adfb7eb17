// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "actions/DriveCommand.h"
#include "commands/Commands.h"
#include "commands/PlayOptions.h"
#include "commands/RideOptions.h"
#include "terminal/CommandLine.h"
#include "world/WorldFiles.h"

namespace trainer
{

namespace
{

const std::map<std::string, simulation::GroundKind> kSurfaces{
    {"asphalt", simulation::GroundKind::asphalt}, {"wet", simulation::GroundKind::wetAsphalt},
    {"gravel", simulation::GroundKind::gravel},   {"grass", simulation::GroundKind::grass},
    {"snow", simulation::GroundKind::snow},       {"ice", simulation::GroundKind::ice}};

struct DriveLine
{
    PlayOptions play;
    RideOptions ride;
    DriveRequest drive;
};

foundation::Outcome driveOne(const DriveLine& line)
{
    DriveRequest request = line.drive;
    request.play = line.play.request;
    request.play.seed = line.drive.play.seed;
    if (const auto complete = line.ride.complete(request); !complete) return complete;
    if (const auto sound = checkDrive(request); !sound) return sound;
    if (request.play.terrain.file.empty())
    {
        const auto world = defaultWorld();
        if (!world) return world.error();
        request.play.terrain.file = *world;
    }
    return drive(request);
}

} // namespace

std::vector<Command> addDrive(CLI::App& program)
{
    const auto line = std::make_shared<DriveLine>();
    CLI::App* command = program.add_subcommand("drive", "drive a road vehicle by its own physics");
    command->add_option("WORLD", line->play.request.terrain.file,
                        "OpenDRIVE network, or a .roam file with roads; without it the default world");
    command->add_flag("--headless", line->drive.isHeadless, "drive without pictures and without a window");
    command->add_option("--vehicle", line->drive.vehicle, "road vehicle file");
    command->add_option("--duration", line->drive.durationS, "seconds to drive at most")
        ->check(terminal::between(0.1, 1e5));
    command->add_option("--length", line->drive.lengthM, "metres of lanes to drive")
        ->check(terminal::between(20.0, 1e6));
    command->add_option("--speed", line->drive.speedMps, "most that the driver wants, m/s")
        ->check(terminal::between(0.5, 100.0));
    command->add_option("--start-at", line->drive.startM, "metres of the way at which to begin")
        ->check(terminal::between(1.0, 1e6));
    command->add_option("--surface", line->drive.surface, "what the roads are made of")
        ->transform(terminal::named(kSurfaces));
    command->add_option("--csv_logger", line->play.request.output.motionFile, "file for a row of each step");
    command->add_option("--inputs", line->drive.inputs, "inputs file to drive by, in place of the driver");
    command->add_option("--record-inputs", line->drive.recordInputs, "inputs file to write");
    command->add_option("--seed", line->drive.play.seed, "of the traffic");
    line->ride.addTo(*command);
    line->play.addTo(*command);
    return {{command, line->play.running([line] { return driveOne(*line); })}};
}

} // namespace trainer
