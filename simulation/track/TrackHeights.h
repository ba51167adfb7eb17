// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <foundation/Heights.h>

#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// What was done to the heights of a track.
struct TrackHeights
{
    double offsetM = 0.0;         ///< that was added to every height
    std::size_t restingFixes = 0; ///< on the ground, from which the offset was found; 0: none was found
    std::size_t raisedFixes = 0;  ///< were below the ground and are lifted to it
    double deepestM = 0.0;        ///< below the ground before that
    HeightDatum datum = HeightDatum::ellipsoid; ///< of the file
    std::optional<double> geoidM{};             ///< that had been added to count from the ellipsoid

    /// One sentence for the user.
    std::string message() const;
};

/// Puts the heights of a track above the ellipsoid and the drawn ground. Where the recorder stood or rolled
/// on the ground, slower than 2 m/s in the first and the last minute, the median of ground less height is the
/// offset of the datum; without such fixes, or with `findsOffset` = false (a made ground), it is 0. Then no
/// fix stays less than `clearanceM` above the ground, and a fix without height lies on it.
/// Precondition: countFromEllipsoid(). Cost: one look-up for each fix. Differs from a geoid model: what the
/// barometer of the day adds is found, too.
TrackHeights fitToGround(FlightTrack& track, const foundation::HeightOnEarth& ground, double clearanceM = 0.0,
                         bool findsOffset = true);

} // namespace simulation
