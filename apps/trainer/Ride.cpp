// SPDX-License-Identifier: Apache-2.0
#include "Ride.h"

#include "HeadlessCommand.h"
#include "PlayCommand.h"
#include "simulation/player/ScenarioPlayer.h"

namespace trainer
{

namespace
{

constexpr int kRideStepsPerSecond = 120;

foundation::Outcome rideHeadless(const RideRequest& request, const SceneTerrain& terrain, Ride ride)
{
    HeadlessRequest headless;
    headless.stepS = 1.0 / kRideStepsPerSecond;
    headless.durationS = request.durationS;
    headless.logFile = request.play.output.motionFile;
    headless.scenario = ride.name;
    simulation::PlayerOptions options;
    options.origin = terrain.origin();
    options.ground = terrain.ground();
    options.clock = simulation::FixedClock(kRideStepsPerSecond);
    options.motions[ride.entity] = ride.motion;
    auto player = simulation::ScenarioPlayer::create(std::move(ride.scenario), std::move(options));
    if (!player) return player.error();
    return playOut(**player, headless);
}

} // namespace

foundation::Outcome playRide(const RideRequest& request, SceneTerrain terrain, Ride ride)
{
    if (request.isHeadless) return rideHeadless(request, terrain, std::move(ride));
    PlayRequest play = request.play;
    play.motions[ride.entity] = ride.motion;
    play.longestS = request.durationS;
    return playScene(std::move(terrain), std::move(ride.scenario), play);
}

} // namespace trainer
