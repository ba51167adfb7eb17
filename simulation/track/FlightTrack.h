// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace simulation
{

/// What the heights of a track count from.
enum class HeightDatum
{
    ellipsoid,    ///< WGS84
    meanSeaLevel, ///< the geoid, up to 107 m from the ellipsoid
    pressure,     ///< the standard atmosphere over mean sea level: off by the weather of the day
    ground,
};

/// Returns the datum in words, for messages.
const char* nameOf(HeightDatum datum);

/// What moved, as far as the file tells.
enum class TrackKind
{
    unknown,
    aircraft,
    helicopter,
    ship,
    vehicle,
    person,
    thing,
    mark, ///< no body: a waypoint, a bullseye
};

/// A recorded attitude. Degrees: yaw clockwise from true north, pitch nose up, roll right side down. What is
/// absent follows from the way.
struct TrackAttitude
{
    double yawDeg = 0.0;
    std::optional<double> pitchDeg{}, rollDeg{};
};

/// A recorded position. WGS84 degrees, metres.
struct TrackFix
{
    double timeS =
        0.0; ///< since 1970-01-01T00:00:00Z, or since the start of the recording where it has no date
    double latitudeDeg = 0.0, longitudeDeg = 0.0;
    std::optional<double> heightM;
    int line = 0; ///< of the file
    std::optional<TrackAttitude> attitude{};
    std::optional<HeightDatum> datum{}; ///< of this height; absent: that of the track
    std::optional<double> geoidM{};     ///< mean sea level above the ellipsoid here, as the file has it
    std::optional<double> speedMps{};   ///< over ground, as the file has it
};

/// A flight, a drive or a walk that somebody recorded.
/// Invariant: where it has times they rise; coordinates are in their ranges.
struct FlightTrack
{
    std::string name;
    std::vector<TrackFix> fixes; ///< one at least
    HeightDatum datum = HeightDatum::meanSeaLevel;
    bool hasTimes = true; ///< no: all are 0
    TrackKind kind = TrackKind::unknown;
    std::optional<double> endS{};   ///< when it was taken out of the recording, on the clock of the fixes
    std::optional<double> geoidM{}; ///< mean of what countFromEllipsoid() has added to the heights
};

/// A record that is passed over, or one of the notes.
struct TrackProblem
{
    int line = 0;
    std::string what;
};

struct TrackReading
{
    std::vector<FlightTrack> tracks; ///< in the file's order
    std::vector<TrackProblem> problems;
    std::size_t problemCount = 0;    ///< with those beyond the thousand that are kept
    std::vector<TrackProblem> notes; ///< what is in effect, but otherwise than it is written
};

} // namespace simulation
