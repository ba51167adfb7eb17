// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "simulation/track/ReadTrack.h"
#include "simulation/track/TrackHeights.h"
#include "simulation/track/TrackTrajectory.h"

using TrackParser = foundation::Result<simulation::TrackReading> (*)(std::string_view, const std::string&);

/// Any bytes may be given as a recorded track: what is read rises in time, lies on the Earth, and makes a
/// trajectory.
inline int fuzzTrack(TrackParser parse, const std::uint8_t* data, std::size_t size)
{
    auto reading = parse(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
    if (!reading) return 0;
    if (reading->tracks.empty()) std::abort();
    for (simulation::FlightTrack& track : reading->tracks)
    {
        if (track.fixes.empty()) std::abort();
        simulation::fitToGround(track, [](double, double) { return 100.0; });
        for (std::size_t i = 0; i < track.fixes.size(); ++i)
        {
            const simulation::TrackFix& fix = track.fixes[i];
            if (!(std::fabs(fix.latitudeDeg) <= 90.0 && std::fabs(fix.longitudeDeg) <= 180.0)) std::abort();
            if (!fix.heightM || !(*fix.heightM >= 100.0)) std::abort();
            if (track.hasTimes && i > 0 && !(fix.timeS > track.fixes[i - 1].timeS)) std::abort();
        }
        const auto trajectory = simulation::trajectoryOf(track);
        if (!trajectory && track.fixes.size() > 1) std::abort();
    }
    return 0;
}
