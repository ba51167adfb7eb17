// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackTrajectory.h"

#include <algorithm>

#include <foundation/Angle.h>
#include <foundation/Utf8.h>

#include "simulation/track/TrackGaps.h"

namespace simulation
{

namespace
{

Orientation orientationOf(const TrackAttitude& attitude)
{
    Orientation orientation;
    orientation.headingRad = foundation::radiansOf(90.0 - attitude.yawDeg);
    if (attitude.pitchDeg) orientation.pitchRad = -foundation::radiansOf(*attitude.pitchDeg);
    if (attitude.rollDeg) orientation.rollRad = foundation::radiansOf(*attitude.rollDeg);
    return orientation;
}

} // namespace

foundation::Result<FollowTrajectoryAction> trajectoryOf(const FlightTrack& track)
{
    if (track.fixes.size() < 2)
        return foundation::Error{track.name, "has one position only", "take a track that moves"};
    Polyline line;
    double lastS = 0.0;
    const bool hasAttitudes = std::all_of(track.fixes.begin(), track.fixes.end(),
                                          [](const TrackFix& fix) { return fix.attitude.has_value(); });
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
        if (hasAttitudes) position.orientation = orientationOf(*fix.attitude);
        line.vertices.push_back(
            {{fix.line}, track.hasTimes ? std::optional(timeS) : std::nullopt, std::move(position)});
    }
    if (track.hasTimes) fillGaps(line.vertices);
    foundation::Result<FollowTrajectoryAction> result{FollowTrajectoryAction{}};
    result->trajectory.name =
        std::string(foundation::utf8Beginning(track.name, 256)); // the longest name that a scenario may have
    result->trajectory.shape = std::move(line);
    result->mode = FollowingMode::follow;
    if (track.hasTimes) result->timing = Timing{};
    return result;
}

} // namespace simulation
