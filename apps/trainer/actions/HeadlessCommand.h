// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include <foundation/Result.h>

#include "simulation/player/ScenarioPlayer.h"
#include "simulation/road/WithoutRoads.h"

namespace trainer
{

/// The arguments of `trainer play --headless`.
struct HeadlessRequest
{
    std::filesystem::path scenario;
    double stepS = 0.01;
    bool hasStep = false;                            ///< one was asked for
    double durationS = 3600.0;                       ///< limit for a scenario that never ends
    std::filesystem::path logFile;                   ///< empty: none
    std::map<std::string, std::string> parameters{}; ///< values instead of the scenario's
    std::uint64_t seed = 0;                          ///< of what the player leaves to chance
    simulation::WithoutRoads without = simulation::WithoutRoads::refused;
};

/// Plays to the stop trigger, until all motions that were lent are done, or request.durationS, with the log
/// of request.logFile; prints how fast. Errors: a file that cannot be written.
foundation::Outcome playOut(simulation::ScenarioPlayer& player, const HeadlessRequest& request);

/// Plays a scenario to its stop trigger without a picture: neither terrain nor models are opened, only its
/// roads. What the scenario has and the player has not is told on stderr, one line each, and passed over.
/// Errors: as readScenario() and ScenarioPlayer::create(); a file that cannot be written.
foundation::Outcome playHeadless(const HeadlessRequest& request);

} // namespace trainer
