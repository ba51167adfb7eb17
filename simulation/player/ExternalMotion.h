// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include "simulation/player/Traffic.h"

namespace simulation
{

/// Moves one entity of a scenario by something else than its actions: a vehicle with physics and whoever controls it.
class ExternalMotion
{
public:
    virtual ~ExternalMotion() = default;

    /// Begins where the Init actions put the entity: an airborne one with a speed flies, any other stands on the ground or rolls.
    /// Errors: it cannot begin there.
    virtual foundation::Outcome begin(const EntityState& start, bool isAirborne) = 0;

    /// Moves on to a later time. `traffic`: the scene before.
    virtual void advanceTo(double timeS, const Traffic& traffic) = 0;

    /// At the time of the last advanceTo(). The name is left empty.
    virtual const EntityState& state() const = 0;

    /// Whether its controller has done all that it was told.
    virtual bool isDone() const = 0;

    /// What a person should know of it (a crash, a lost process); empty: nothing.
    virtual std::string note() const = 0;
};

} // namespace simulation
