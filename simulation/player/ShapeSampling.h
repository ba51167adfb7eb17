// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/player/PositionSolver.h"
#include "simulation/scenario/Trajectory.h"

namespace simulation
{

/// Turns the shape of a trajectory into a polyline of WorldPositions, the directions of curves given as
/// headings; a polyline keeps its vertices. Clothoids have samples at most 0.1 m apart (20 000 of them where
/// they are longer than 2 km): between two of them a curve of a radius of 5 m leaves the chord by 0.25 mm. A
/// NURBS has one for each metre of its control polygon, as in esmini. Times are those of the shape:
/// - a clothoid, or each one of a spline, is driven evenly from its start time to its end;
/// - a NURBS is at the place where the basis function of a control point is greatest at the time of that
///   point, and its parameter grows evenly between (the standard does not say; esmini does the same).
/// `actor`: where a spline begins that does not say it; null: nowhere. Nothing: a position cannot be placed.
std::optional<Polyline> sampledShape(const TrajectoryShape& shape, const PositionSolver& positions,
                                     const EntityState* actor);

/// Returns the place on a trajectory at a distance, to the left of it by tM.
std::optional<Placement> placeOnTrajectory(const TrajectoryPosition& position,
                                           const PositionSolver& positions);

} // namespace simulation
