// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "simulation/player/EntityState.h"
#include "simulation/player/SceneFrame.h"
#include "simulation/scenario/Entity.h"

namespace simulation
{

/// Where an entity touches the ground: four points of its body, at height 0 of its own frame.
/// Units: metres. Order: front left, front right, rear left, rear right.
struct GroundContact
{
    double frontXM = 0.0;
    double rearXM = 0.0;
    double halfTrackM = 0.0;

    /// The wheels of a vehicle; for anything else the corners of its bounding box.
    static GroundContact of(const ScenarioObject& object);
};

/// Stands an entity on the ground at its place and heading: the four points are let down on the true surface, and
/// the plane that fits them best (equal weights) gives height, pitch and roll; what each is off the plane is its
/// wheel's travel. The state is unchanged where any point is beyond the data.
/// The points keep their distances along the slope: pitch and roll are found in three rounds, from level.
void standOnGround(const GroundContact& contact, const SceneFrame& frame, EntityState& state);

} // namespace simulation
