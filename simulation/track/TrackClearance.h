// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <foundation/Heights.h>

#include "simulation/player/SceneFrame.h"
#include "simulation/scenario/RoutingActions.h"
#include "simulation/track/TrackHeights.h"

namespace simulation
{

/// What was done to a trajectory to keep it above the ground between its vertices.
struct TrackClearance
{
    std::size_t addedVertices = 0;
    double deepestM = 0.0; ///< below the ground before that
    double leftM = 0.0;    ///< below the ground after it, where that could not be mended
};

/// Adds vertices where the curve through a polyline goes below the ground: at the deepest point of each
/// segment, on the ground, until nothing is more than 5 cm below it. The curve is looked at every 15 m, at 64
/// places of a segment at most. Vertices stay where they are. Precondition: `frame` has an origin and can
/// place every vertex.
/// Cost: some look-ups of the ground a segment.
TrackClearance keepAboveGround(FollowTrajectoryAction& action, const SceneFrame& frame);

/// The ground below places on earth, by the frame of a scene. `frame` has an origin, and must outlive the
/// function.
foundation::HeightOnEarth groundHeightOf(const SceneFrame& frame);

} // namespace simulation
