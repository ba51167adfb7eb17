// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackTrajectory.h"

namespace simulation
{

foundation::Result<FollowTrajectoryAction> trajectoryOf(const FlightTrack& track)
{
    if (track.fixes.size() < 2)
        return foundation::Error{track.name, "has one position only", "take a track that moves"};
    Polyline line;
    double lastS = 0.0;
    for (const TrackFix& fix : track.fixes)
    {
        const double timeS = fix.timeS - track.fixes.front().timeS;
        if (track.hasTimes && !line.vertices.empty() && !Vertex::isLater(lastS, timeS)) continue;
        lastS = timeS;
        GeoPosition position;
        position.source = {fix.line};
        position.latitudeDeg = fix.latitudeDeg;
        position.longitudeDeg = fix.longitudeDeg;
        position.heightM = fix.heightM;
        line.vertices.push_back(
            {{fix.line}, track.hasTimes ? std::optional(timeS) : std::nullopt, std::move(position)});
    }
    foundation::Result<FollowTrajectoryAction> result{FollowTrajectoryAction{}};
    result->trajectory.name = track.name.substr(0, 256); // the longest name that a scenario may have
    result->trajectory.shape = std::move(line);
    result->mode = FollowingMode::follow;
    if (track.hasTimes) result->timing = Timing{};
    return result;
}

} // namespace simulation
