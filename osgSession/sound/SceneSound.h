// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/player/ExternalMotion.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/sound/SoundState.h"
#include "simulation/state/EntityState.h"
#include "simulation/vehicle/DynamicVehicle.h"

namespace trainer
{

/// What somebody in an entity of a play hears. It remembers what was before: whether wheels touched.
/// Determinism: the same calls give the same states. Threads: one.
class SceneSound
{
public:
    /// `listener`: index of the entity.
    SceneSound(const simulation::Scenario& scenario, std::size_t listener);

    /// `vehicle`: the listener's physics; null: it moves without.
    simulation::SoundState hear(const std::vector<simulation::EntityState>& entities,
                                const simulation::DynamicVehicle* vehicle);

private:
    void addPassing(const std::vector<simulation::EntityState>& entities,
                    simulation::SoundState& sound) const;

    /// What kinds of entities sound like; loudness 0: silent.
    struct Source
    {
        double loudness = 0.0, idleHz = 40.0, hzPerMps = 3.0;
    };
    static Source sourceOf(const simulation::ScenarioObject& object);

    std::vector<Source> _sources; ///< by entity
    std::size_t _listener;
    bool _flies = false, _wasOnGround = true;
    double _sinkMps = 0.0; ///< before wheels touched
};

/// The vehicle that moves as its physics tell; null: it moves without.
const simulation::DynamicVehicle* vehicleOf(const simulation::ExternalMotion* motion);

} // namespace trainer
