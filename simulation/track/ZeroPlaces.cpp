// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/ZeroPlaces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simulation
{

std::vector<std::size_t> dropZeroPlaces(FlightTrack& track, std::vector<int>& lines)
{
    constexpr double kAwayDeg = 1.0;
    const auto isZero = [](const TrackFix& fix) { return fix.latitudeDeg == 0.0 && fix.longitudeDeg == 0.0; };
    const auto isNear = [&](const TrackFix& fix) {
        return !isZero(fix) && std::fabs(fix.latitudeDeg) < kAwayDeg &&
               std::fabs(fix.longitudeDeg) < kAwayDeg;
    };
    const auto& fixes = track.fixes;
    std::vector<std::size_t> dropped;
    if (std::all_of(fixes.begin(), fixes.end(), isZero) || std::any_of(fixes.begin(), fixes.end(), isNear))
        return dropped;
    std::vector<TrackFix> kept;
    for (std::size_t i = 0; i < fixes.size(); ++i)
        if (isZero(fixes[i]))
            dropped.push_back(i), lines.push_back(fixes[i].line);
        else
            kept.push_back(fixes[i]);
    if (!dropped.empty()) track.fixes = std::move(kept);
    return dropped;
}

} // namespace simulation
