// SPDX-License-Identifier: Apache-2.0
#include "PlayRides.h"

#include <cstdio>

#include <foundation/WholeFile.h>

#include "HeadlessCommand.h"
#include "PlayCommand.h"
#include "scene/RideRoads.h"
#include "scene/SceneTerrain.h"
#include "simulation/control/ControlSwitch.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/player/ScenarioPlayer.h"
#include "window/WindowSession.h"

namespace trainer
{

namespace
{

foundation::Outcome rideHeadless(const RideRequest& request, const SceneTerrain& terrain, Ride ride)
{
    HeadlessRequest headless;
    headless.stepS = 1.0 / kSeatStepsPerSecond;
    headless.durationS = request.durationS;
    headless.logFile = request.play.output.motionFile;
    headless.scenario = ride.name;
    simulation::PlayerOptions options;
    options.origin = terrain.origin();
    options.ground = terrain.ground();
    options.clock = simulation::FixedClock(kSeatStepsPerSecond);
    options.motions[ride.entity] = ride.motion;
    options.roadsUnder = request.play.roadsUnder;
    options.roads = request.play.trafficRoads;
    options.seed = request.play.seed;
    auto player = simulation::ScenarioPlayer::create(std::move(ride.scenario), std::move(options));
    if (!player) return player.error();
    return playOut(**player, headless);
}

foundation::Outcome rideInPictures(const RideRequest& request, SceneTerrain terrain, Ride ride)
{
    PlayRequest play = request.play;
    play.motions[ride.entity] = ride.motion;
    play.longestS = request.durationS;
    return playScene(std::move(terrain), std::move(ride.scenario), play);
}

} // namespace

void openRoads(RideRequest& request, const SceneTerrain& terrain)
{
    addRoads(request.play, terrain);
    if (terrain.roads || !(request.play.trafficPerKm > 0.0)) return;
    std::printf("note: there are no roads in this world, so there is no traffic\n");
    request.play.trafficPerKm = 0.0;
}

foundation::Result<std::shared_ptr<simulation::VehicleMotion>>
playRides(const RideRequest& request, SceneTerrain terrain, RideMaker& maker)
{
    if (request.hasWindow())
    {
        auto session =
            WindowSession::create({}, std::move(terrain), request.play, &maker, request.recordInputs);
        if (!session) return session.error();
        if (const auto shown = (*session)->run(); !shown) return shown.error();
        return (*session)->motion();
    }
    auto ride = maker.make(0);
    if (!ride) return ride.error();
    const auto motion = ride->motion;
    const auto played = request.isHeadless ? rideHeadless(request, terrain, std::move(*ride))
                                           : rideInPictures(request, std::move(terrain), std::move(*ride));
    if (!played) return played.error();
    if (!request.recordInputs.empty())
        if (const auto written = motion->vehicle().recorder()->write(request.recordInputs); !written)
            return written.error();
    return motion;
}

} // namespace trainer
