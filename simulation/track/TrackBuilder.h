// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <foundation/Result.h>

#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// Gathers the tracks of a file and what is wrong with it.
class TrackBuilder
{
public:
    explicit TrackBuilder(std::string name) : _name(std::move(name)) {}

    /// Begins a track; one without fixes is left out at the end.
    FlightTrack& begin(const std::string& name, HeightDatum datum);

    /// Adds a fix to a track; nothing of it where a coordinate is out of its range, or its time not later
    /// than the one before.
    void add(FlightTrack& track, const TrackFix& fix);

    void problem(int line, const std::string& what);

    /// Errors: there is no fix at all; with the first problem.
    foundation::Result<TrackReading> finish();

private:
    std::string _name;
    TrackReading _reading;
};

/// Takes the first line off a text, without its end.
std::string_view takeLine(std::string_view& text);

/// Returns a text without blanks at both ends.
std::string_view trimmed(std::string_view text);

} // namespace simulation
