// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackHeights.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "simulation/track/TrackMotion.h"

namespace simulation
{
namespace
{

constexpr double kRestMps = 2.0;
constexpr double kRestS = 60.0;
constexpr std::size_t kFewestResting = 3;

bool isResting(const FlightTrack& track, std::size_t i)
{
    if (i + 1 >= track.fixes.size() || !track.hasTimes) return false;
    const TrackFix& fix = track.fixes[i];
    const bool isAtAnEnd =
        fix.timeS - track.fixes.front().timeS <= kRestS || track.fixes.back().timeS - fix.timeS <= kRestS;
    const double seconds = track.fixes[i + 1].timeS - fix.timeS;
    return isAtAnEnd && metresBetween(fix, track.fixes[i + 1]) < kRestMps * seconds;
}

double median(std::vector<double>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

std::string TrackHeights::message() const
{
    char text[256];
    std::string message = std::string("heights above ") + nameOf(datum);
    if (geoidM)
    {
        std::snprintf(text, sizeof text, ", which is %.1f m above the ellipsoid there", *geoidM);
        message += text;
    }
    if (restingFixes > 0)
    {
        std::snprintf(text, sizeof text, ": %+.1f m added (%zu fixes at rest on the ground)", offsetM,
                      restingFixes);
        message += text;
    }
    if (raisedFixes > 0)
    {
        std::snprintf(text, sizeof text,
                      "; %zu fixes were below the ground, by %.1f m at most, and are lifted to it",
                      raisedFixes, deepestM);
        message += text;
    }
    return message;
}

TrackHeights fitToGround(FlightTrack& track, const foundation::HeightOnEarth& ground, double clearanceM,
                         bool findsOffset)
{
    TrackHeights done;
    done.datum = track.datum;
    done.geoidM = track.geoidM;
    const auto isAboveGround = [&](const TrackFix& fix)
    { return fix.datum.value_or(track.datum) == HeightDatum::ground; };
    std::vector<std::optional<double>> heights;
    std::vector<double> differences;
    for (std::size_t i = 0; i < track.fixes.size(); ++i)
    {
        const TrackFix& fix = track.fixes[i];
        heights.push_back(ground(fix.latitudeDeg, fix.longitudeDeg));
        if (!isAboveGround(fix) && heights.back() && fix.heightM && isResting(track, i))
            differences.push_back(*heights.back() - *fix.heightM);
    }
    if (findsOffset && differences.size() >= kFewestResting)
    {
        done.restingFixes = differences.size();
        done.offsetM = median(differences);
    }
    for (std::size_t i = 0; i < track.fixes.size(); ++i)
    {
        std::optional<double>& height = track.fixes[i].heightM;
        if (!heights[i])
        {
            if (height && !isAboveGround(track.fixes[i])) *height += done.offsetM;
            continue;
        }
        const double least = *heights[i] + clearanceM;
        if (!height)
            height = least;
        else
            *height += isAboveGround(track.fixes[i]) ? *heights[i] : done.offsetM;
        if (*height >= least) continue;
        ++done.raisedFixes;
        done.deepestM = std::max(done.deepestM, *heights[i] - *height);
        height = least;
    }
    track.datum = HeightDatum::ellipsoid;
    for (TrackFix& fix : track.fixes)
        fix.datum.reset();
    return done;
}

} // namespace simulation
