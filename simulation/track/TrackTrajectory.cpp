// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackTrajectory.h"

#include <algorithm>

#include <foundation/Angle.h>

namespace simulation
{

namespace
{

Orientation orientationOf(const TrackAttitude& attitude)
{
    Orientation orientation;
    orientation.headingRad = foundation::radiansOf(90.0 - attitude.yawDeg);
    orientation.pitchRad = -foundation::radiansOf(attitude.pitchDeg);
    orientation.rollRad = foundation::radiansOf(attitude.rollDeg);
    return orientation;
}

constexpr double kLongGapS = 30.0;
constexpr double kGapStepS = 10.0;
constexpr int kMostInGap = 200;

/// Puts places on the straight way between two vertices that are far apart in time, where a smooth curve
/// would swing out.
void fillGap(std::vector<Vertex>& vertices, const Vertex& next)
{
    if (vertices.empty() || !next.timeS) return;
    const Vertex last = vertices.back();
    const double gapS = *next.timeS - *last.timeS;
    if (gapS <= kLongGapS) return;
    const auto& from = std::get<GeoPosition>(last.position);
    const auto& to = std::get<GeoPosition>(next.position);
    const int steps = static_cast<int>(std::clamp(gapS / kGapStepS, 2.0, static_cast<double>(kMostInGap)));
    for (int i = 1; i < steps; ++i)
    {
        const double share = static_cast<double>(i) / steps;
        GeoPosition between = share < 0.5 ? from : to;
        between.latitudeDeg = from.latitudeDeg + share * (to.latitudeDeg - from.latitudeDeg);
        between.longitudeDeg = foundation::wrappedDeg(
            from.longitudeDeg + share * foundation::wrappedDeg(to.longitudeDeg - from.longitudeDeg));
        if (from.heightM && to.heightM)
            between.heightM = *from.heightM + share * (*to.heightM - *from.heightM);
        vertices.push_back({last.source, *last.timeS + share * gapS, std::move(between)});
    }
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
        Vertex next{{fix.line}, track.hasTimes ? std::optional(timeS) : std::nullopt, std::move(position)};
        fillGap(line.vertices, next);
        line.vertices.push_back(std::move(next));
    }
    foundation::Result<FollowTrajectoryAction> result{FollowTrajectoryAction{}};
    result->trajectory.name = track.name.substr(0, 256); // the longest name that a scenario may have
    result->trajectory.shape = std::move(line);
    result->mode = FollowingMode::follow;
    if (track.hasTimes) result->timing = Timing{};
    return result;
}

} // namespace simulation
