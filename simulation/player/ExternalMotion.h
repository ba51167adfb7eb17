// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <foundation/Result.h>

#include "simulation/contact/Impact.h"
#include "simulation/player/Traffic.h"
#include "simulation/player/controllers/EntityController.h"

namespace simulation
{

/// Moves one entity of a scenario by a vehicle with physics and whoever controls it.
class ExternalMotion : public EntityController
{
public:
    /// Begins where the Init actions put the entity: an airborne one with a speed flies, any other stands on
    /// the ground or rolls.
    /// Errors: it cannot begin there.
    /// `environment`: at the time `timeS` of the simulation, which is its begin.
    virtual foundation::Outcome begin(const EntityState& start, bool isAirborne, double timeS,
                                      const EnvironmentState& environment) = 0;

    /// Moves on to a later time. `traffic`: the scene before.
    virtual void advanceTo(double timeS, const Traffic& traffic) = 0;

    /// By advanceTo(); the entity takes the state over.
    void move(ActionScene& scene, int actor) final;

    /// At the time of the last advanceTo(). The name is left empty.
    virtual const EntityState& state() const = 0;

    /// Whether its controller has done all that it was told.
    virtual bool isDone() const = 0;

    /// What a person should know of it (a crash, a lost process); empty: nothing.
    virtual std::string note() const = 0;

    /// What it hit since it began, in the order of time; times count from begunS().
    virtual std::span<const Impact> impacts() const { return {}; }
    virtual double begunS() const { return 0.0; }

    /// Which entities it touched in the last advanceTo(), ascending.
    virtual std::span<const int> touched() const { return {}; }
};

} // namespace simulation
