// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <foundation/Result.h>

#include "simulation/player/PathCurve.h"
#include "simulation/player/SceneFrame.h"
#include "simulation/road/WayAhead.h"
#include "simulation/scenario/Action.h"

namespace simulation
{

/// The motion of one entity along a trajectory, by the times of the vertices or at a given speed.
class TrajectoryRun
{
public:
    /// Checks shape, positions and times of an action. Errors: the reason why it cannot be run.
    static std::optional<std::string> obstacle(const FollowTrajectoryAction& action, const SceneFrame& frame);

    /// Precondition: no obstacle(). A vertex without time at the position of the vertex before it is left
    /// out.
    /// `inPlan`: distances and speeds are seen from above, as esmini counts them on roads.
    TrajectoryRun(const FollowTrajectoryAction& action, const SceneFrame& frame, double startTimeS,
                  bool inPlan);

    bool isTimed() const { return _timing.has_value(); }

    /// Advances to a time (trajectories with times) or by a distance. Returns the seconds or metres that
    /// remain beyond the end, or nothing while the trajectory runs.
    std::optional<double> advanceTo(double timeS);
    std::optional<double> advanceBy(double distanceM);

    PathPoint point() const { return _curve.at(_parameter); }

    /// Returns places of the rest, a metre apart, up to a length; a closed one goes round. The first is where
    /// it now is.
    std::vector<AheadPoint> pointsAhead(double lengthM) const;

    /// Returns the way along the rest to where it comes nearest to a place; nothing where it stays farther
    /// than 5 m from it.
    std::optional<double> wayTo(const glm::dvec3& place) const;

    /// Goes on from where the rest comes nearest to a place, and is so much earlier or later than its times.
    void rejoin(const glm::dvec3& place, double timeS);

    /// Returns the speed of the curve at the current point, for trajectories with times; 0 before the time of
    /// the first vertex.
    double timedSpeedMps() const;

private:
    double parameterAtTime(double timeS) const;
    std::optional<double> wayTo(const glm::dvec3& place, double farthestM) const;

    std::optional<Timing> _timing;
    double _startTimeS;
    bool _inPlan;
    PathCurve _curve;
    double _parameter;
    double _timeOffset = 0.0; ///< added to the parameter for a start inside the trajectory
    double _distanceM = 0.0;
    double _lengthM = 0.0; ///< where the trajectory ends
    bool _hasBegun = true;
};

} // namespace simulation
