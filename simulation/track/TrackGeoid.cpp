// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackGeoid.h"

#include <algorithm>
#include <cmath>

#include <foundation/Geoid.h>

namespace simulation
{
namespace
{

bool countsFromSea(const FlightTrack& track, const TrackFix& fix)
{
    const HeightDatum datum = fix.datum.value_or(track.datum);
    return fix.heightM && (datum == HeightDatum::meanSeaLevel || datum == HeightDatum::pressure);
}

/// `geoid`: null where there is none. Returns false where it is asked for.
bool raise(FlightTrack& track, const foundation::Geoid* geoid)
{
    std::vector<double> latitudes, longitudes;
    for (const TrackFix& fix : track.fixes)
    {
        latitudes.push_back(fix.latitudeDeg);
        longitudes.push_back(fix.longitudeDeg);
    }
    std::vector<double> heights(latitudes.size(), std::nan(""));
    if (geoid) geoid->heights(latitudes, longitudes, heights);
    double sum = 0.0;
    std::size_t raised = 0;
    bool isComplete = true;
    for (std::size_t i = 0; i < track.fixes.size(); ++i)
    {
        TrackFix& fix = track.fixes[i];
        if (!countsFromSea(track, fix)) continue;
        constexpr double kMostGeoidM = 120.0; // a file may have anything
        const bool hasOwn = fix.geoidM && std::fabs(*fix.geoidM) <= kMostGeoidM;
        const double geoidM = hasOwn ? *fix.geoidM : heights[i];
        isComplete = isComplete && std::isfinite(geoidM);
        if (!std::isfinite(geoidM)) continue;
        *fix.heightM += geoidM;
        sum += geoidM;
        ++raised;
    }
    if (raised > 0) track.geoidM = sum / static_cast<double>(raised);
    return isComplete;
}

} // namespace

std::optional<std::string> countFromEllipsoid(std::vector<FlightTrack>& tracks)
{
    const auto isFromSea = [](const FlightTrack& track)
    {
        return !track.geoidM && std::any_of(track.fixes.begin(), track.fixes.end(),
                                            [&](const TrackFix& fix) { return countsFromSea(track, fix); });
    };
    std::optional<foundation::Geoid> geoid;
    if (std::any_of(tracks.begin(), tracks.end(), isFromSea)) geoid = foundation::Geoid::open();
    bool isComplete = true;
    for (FlightTrack& track : tracks)
        if (isFromSea(track)) isComplete = raise(track, geoid ? &*geoid : nullptr) && isComplete;
    if (isComplete) return std::nullopt;
    return "heights above the sea are taken as above the ellipsoid, up to 107 m off: PROJ does not find the "
           "grid "
           "egm96_15.gtx of Debian's proj-data";
}

void setDatum(std::vector<FlightTrack>& tracks, HeightDatum datum)
{
    for (FlightTrack& track : tracks)
    {
        track.datum = datum;
        for (TrackFix& fix : track.fixes)
            fix.datum.reset();
    }
}

double geoidHeightM(double latitudeDeg, double longitudeDeg)
{
    const auto geoid = foundation::Geoid::open();
    const double heightM = geoid ? geoid->heightM(latitudeDeg, longitudeDeg) : 0.0;
    return std::isfinite(heightM) ? heightM : 0.0;
}

} // namespace simulation
