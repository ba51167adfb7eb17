// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <foundation/Result.h>

#include "simulation/player/ExternalMotion.h"
#include "simulation/road/WayAhead.h"

namespace simulation
{

/// How an entity is when something else begins to move it.
struct MotionStart
{
    const EntityState& state;
    bool isAirborne = false;
    double timeS = 0.0;
    const EnvironmentState& environment;
    WayAhead way{}; ///< on which it would go on by itself; no points: straight ahead
};

/// Makes what moves entities whose controllers drive a vehicle with physics.
class MotionSource
{
public:
    virtual ~MotionSource() = default;

    /// Whether a controller can be used for an entity, before the play begins. Errors: its properties and
    /// files; the place is left to the caller.
    virtual foundation::Outcome check(const Controller& controller, const ScenarioObject& object) = 0;

    /// Makes a motion that has begun. Errors: as check(), and a start where the vehicle cannot be.
    virtual foundation::Result<std::shared_ptr<ExternalMotion>>
    make(const Controller& controller, const ScenarioObject& object, const MotionStart& start) = 0;
};

} // namespace simulation
