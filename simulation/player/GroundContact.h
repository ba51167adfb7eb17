// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "simulation/player/SceneFrame.h"
#include "simulation/scenario/Entity.h"
#include "simulation/state/EntityState.h"

namespace simulation
{

/// The four points at which an entity touches the ground, at height 0 of its own frame.
/// Units: metres. Order: front left, front right, rear left, rear right.
struct GroundContact
{
    double frontXM = 0.0;
    double rearXM = 0.0;
    double halfTrackM = 0.0;

    /// Returns the wheels of a vehicle, or the corners of the bounding box of another entity.
    static GroundContact of(const ScenarioObject& object);
};

/// Puts an entity on the ground at its position and heading; where surfaces lie over each other, on the one
/// at its height. The plane that fits the ground below the four points best (equal weights) gives height,
/// pitch and roll; the distance of each point from that plane is the travel of its wheel. The state is
/// unchanged when a point is outside the data.
/// The points keep their distances along the slope: three iterations find pitch and roll, starting level.
void standOnGround(const GroundContact& contact, const SceneFrame& frame, EntityState& state);

} // namespace simulation
