// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <foundation/Result.h>

#include "simulation/player/MotionSource.h"

namespace simulation
{

/// A place in an entity where a person may sit. Before each step the player asks whether the person has the
/// entity; then a vehicle of the seat moves it in place of the scenario.
/// Determinism: isWanted() must depend on the time of the simulation and on calls between steps alone.
class Seat
{
public:
    virtual ~Seat() = default;

    /// Hears that a manual controller of the storyboard was activated, or deactivated.
    virtual void ask(bool isTaken) = 0;

    /// Whether the person has the entity in the step that follows. Units: seconds of the simulation.
    virtual bool isWanted(double timeS) const = 0;

    /// Makes the vehicle of the seat where the entity is, begun. Errors: it cannot begin there.
    virtual foundation::Result<std::shared_ptr<ExternalMotion>> take(const ScenarioObject& object,
                                                                     const MotionStart& start) = 0;

    /// The entity was given back, or is not there any more.
    virtual void leave(double timeS) = 0;

    /// take() failed: nothing is wanted until the person or the storyboard asks anew.
    virtual void refuse(const foundation::Error& error) = 0;

    /// Whether what the person does is over at a time: recorded inputs have ended.
    virtual bool isDone(double timeS) const = 0;
};

} // namespace simulation
