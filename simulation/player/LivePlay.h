// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "simulation/clock/RealTimePace.h"
#include "simulation/player/ScenarioPlayer.h"

namespace simulation
{

/// Plays a scenario at the pace of a wall clock, for pictures at any rate: it makes the steps that are due,
/// and shows the entities between the last two.
/// Determinism: the states after N steps are the player's own, whenever advance() was called. Threads: one.
class LivePlay
{
public:
    /// Hears of every step, and of the state before the first.
    using Observer = std::function<void(const ScenarioPlayer&)>;

    LivePlay(std::unique_ptr<ScenarioPlayer> player, Observer observer = {});

    /// Makes the steps that are due at a reading of the wall clock. A play that is over pauses.
    void advance(double wallS);

    /// Goes on with another player from its start: a reset, or a start elsewhere.
    void restart(std::unique_ptr<ScenarioPlayer> player);

    /// The entities as a picture shows them, at pace().timeS().
    const std::vector<EntityState>& shown() const { return _shown; }

    RealTimePace& pace() { return _pace; }
    const RealTimePace& pace() const { return _pace; }
    const ScenarioPlayer& player() const { return *_player; }
    bool isOver() const { return _player->isFinished() || _player->areMotionsDone(); }

private:
    void begin();
    void show();

    std::unique_ptr<ScenarioPlayer> _player;
    Observer _observer;
    RealTimePace _pace;
    std::vector<EntityState> _before, _shown;
};

} // namespace simulation
