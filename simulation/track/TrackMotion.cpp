// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackMotion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <foundation/Angle.h>
#include <foundation/Earth.h>

namespace simulation
{
namespace
{

constexpr double kFlyingM = 50.0, kLiftedM = 25.0;
constexpr double kWalkingMps = 2.5;
constexpr double kTrackStandingMps = 0.3;

/// The speed that nine tenths of the moving fixes do not exceed; nothing where nothing moves or there are no
/// times.
std::optional<double> defaultSpeed(const FlightTrack& track)
{
    std::vector<double> speeds;
    if (!track.hasTimes) return std::nullopt;
    for (std::size_t i = 1; i < track.fixes.size(); ++i)
    {
        const double speed = metresBetween(track.fixes[i - 1], track.fixes[i]) /
                             (track.fixes[i].timeS - track.fixes[i - 1].timeS);
        if (speed > kTrackStandingMps) speeds.push_back(speed);
    }
    if (speeds.empty()) return std::nullopt;
    const auto at = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() * 9 / 10);
    std::nth_element(speeds.begin(), at, speeds.end());
    return *at;
}

} // namespace

double metresBetween(const TrackFix& one, const TrackFix& other)
{
    const double north = foundation::radiansOf(other.latitudeDeg - one.latitudeDeg);
    const double east = foundation::radiansOf(foundation::wrappedDeg(other.longitudeDeg - one.longitudeDeg)) *
                        std::cos(foundation::radiansOf(one.latitudeDeg));
    return foundation::kEarthRadiusM * std::hypot(north, east);
}

double lengthOf(const FlightTrack& track)
{
    double length = 0.0;
    for (std::size_t i = 1; i < track.fixes.size(); ++i)
        length += metresBetween(track.fixes[i - 1], track.fixes[i]);
    return length;
}

TrackKind kindByMotion(const FlightTrack& track, const foundation::HeightOnEarth& ground, bool isMadeGround)
{
    if (track.kind != TrackKind::unknown) return track.kind;
    std::size_t flying = 0, lifted = 0;
    for (const TrackFix& fix : track.fixes)
    {
        const auto below = ground(fix.latitudeDeg, fix.longitudeDeg);
        if (!fix.heightM || !below) continue;
        flying += *fix.heightM - *below >= kFlyingM ? 1 : 0;
        lifted += *fix.heightM - *below >= kLiftedM ? 1 : 0;
    }
    if (10 * flying >= track.fixes.size() || (!isMadeGround && 2 * lifted > track.fixes.size()))
        return TrackKind::aircraft;
    const auto speed = defaultSpeed(track);
    return speed && *speed < kWalkingMps ? TrackKind::person : TrackKind::vehicle;
}

} // namespace simulation
