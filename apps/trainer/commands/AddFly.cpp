// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "actions/FlyCommand.h"
#include "commands/Commands.h"
#include "commands/PlayOptions.h"
#include "commands/RideOptions.h"
#include "terminal/CommandLine.h"
#include "world/WorldFiles.h"

namespace trainer
{

namespace
{

struct FlyLine
{
    PlayOptions play;
    RideOptions ride;
    FlyRequest fly;
    std::vector<double> strip;
    bool leavesWorldOut = false;
};

/// Completes a flight. Errors: a strip without length; those of defaultWorld().
foundation::Outcome flyOne(const FlyLine& line)
{
    FlyRequest request = line.fly;
    request.play = line.play.request;
    request.play.seed = line.fly.seed;
    request.takeReportedWind();
    if (const auto complete = line.ride.complete(request); !complete) return complete;
    const std::vector<double>& strip = line.strip;
    if (!strip.empty())
    {
        if (!(strip[3] >= 100.0 && strip[3] <= 10'000.0))
            return foundation::Error{"--strip", "its length is not from 100 to 10000 m",
                                     "write X,Y,COURSE,LENGTH"};
        request.play.terrain.strip = StripRequest{{strip[0], strip[1]}, strip[2], strip[3], 30.0};
    }
    if (const auto sound = checkFlight(request); !sound) return sound;
    if (request.play.terrain.file.empty() && strip.empty() && !line.leavesWorldOut)
    {
        const auto world = defaultWorld();
        if (!world) return world.error();
        request.play.terrain.file = *world;
    }
    return fly(request);
}

} // namespace

std::vector<Command> addFly(CLI::App& program)
{
    const auto line = std::make_shared<FlyLine>();
    CLI::App* command = program.add_subcommand("fly", "fly an aircraft by its own physics");
    command->add_option("WORLD", line->play.request.terrain.file,
                        "terrain to fly over: a .roam file, a raster or an OpenDRIVE network; without it the "
                        "default world, or "
                        "level ground with --strip");
    command->add_flag("--no-world", line->leavesWorldOut, "without WORLD: level ground");
    command->add_flag("--headless", line->fly.isHeadless, "fly without pictures");
    command->add_option("--duration", line->fly.durationS, "seconds to fly at most")
        ->check(terminal::between(0.0, 1e5));
    command->add_option("--csv_logger", line->play.request.output.motionFile, "file for a row of each step");
    command->add_option("--aircraft", line->fly.aircraft,
                        "aircraft file, or with --jsbsim-root the name of an aircraft of JSBSim");
    command->add_option("--jsbsim-root", line->fly.jsbsimRoot,
                        "folder with the aircraft of JSBSim, which flies in a process of its own");
    command->add_option("--jsbsim", line->fly.jsbsim, "JSBSim's program, instead of the one that PATH finds");
    CLI::Option* const inputs = command->add_option("--inputs", line->fly.inputs, "inputs file to fly by");
    command->add_option("--record-inputs", line->fly.recordInputs, "inputs file to write");
    command
        ->add_option("--orders", line->fly.orders,
                     "of the autopilot: takeoff; heading 240; altitude 500; speed 45; wait 30; circuit; land")
        ->excludes(inputs);
    command
        ->add_option("--start", line->fly.start,
                     "X,Y,H,HEADING,SPEED: metres in the scene's frame, metres above the ground, degrees "
                     "from north, m/s")
        ->delimiter(',')
        ->expected(5);
    command
        ->add_option("--strip", line->strip,
                     "X,Y,COURSE,LENGTH of a level strip that is laid: its threshold in the scene's frame, "
                     "degrees from north, metres")
        ->delimiter(',')
        ->expected(4);
    command->add_option("--wind", line->fly.wind, "FROM,KNOTS: degrees from north, kt")
        ->delimiter(',')
        ->expected(2);
    command->add_option("--gusts", line->fly.gustsMps, "standard deviation of turbulence, m/s")
        ->check(terminal::between(0.0, 20.0));
    command->add_option("--seed", line->fly.seed, "of the turbulence and of the traffic");
    line->ride.addTo(*command);
    line->play.addTo(*command);
    return {{command, line->play.running([line] { return flyOne(*line); })}};
}

} // namespace trainer
