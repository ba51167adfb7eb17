// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <foundation/Result.h>

#include "simulation/player/PathCurve.h"
#include "simulation/player/SceneFrame.h"
#include "simulation/scenario/Action.h"

namespace simulation
{

/// One entity on its way along a trajectory, by the vertices' times or at a speed of its own.
class TrajectoryRun
{
public:
    /// Whether an action can be run at all: shape, positions, times. Errors: what stands against it (no place).
    static std::optional<std::string> obstacle(const FollowTrajectoryAction& action, const SceneFrame& frame);

    /// Precondition: no obstacle(). Vertices that lie on their predecessor and have no time are left out.
    TrajectoryRun(const FollowTrajectoryAction& action, const SceneFrame& frame, double startTimeS);

    bool isTimed() const { return _timing.has_value(); }

    /// Goes on to a time, for timed runs, or by a distance. Returns what was left beyond the end: seconds or metres;
    /// nothing while the run goes on.
    std::optional<double> advanceTo(double timeS);
    std::optional<double> advanceBy(double distanceM);

    PathPoint point() const { return _curve.at(_parameter); }

    /// The curve's own speed at the place reached, for timed runs; 0 before the first vertex's time.
    double timedSpeedMps() const;

private:
    double parameterAtTime(double timeS) const;

    std::optional<Timing> _timing;
    double _startTimeS;
    PathCurve _curve;
    double _parameter;
    double _timeOffset = 0.0; ///< added to the parameter for a start inside the trajectory
    double _distanceM = 0.0;
    bool _hasBegun = true;
};

} // namespace simulation
