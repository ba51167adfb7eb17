// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <foundation/Result.h>
#include <foundation/Utf8.h>

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

    /// Tells that the last track goes on with another part: parts are put in the order of their times.
    void beginPart();

    /// Adds a fix to a track; nothing of it where a coordinate is out of its range. Its time may be wrong:
    /// finish() finds out.
    void add(FlightTrack& track, const TrackFix& fix);

    void problem(int line, const std::string& what);
    void note(int line, const std::string& what);
    /// Notes the bytes of a text that are not in its encoding.
    void note(const foundation::Utf8Text& text);

    /// Puts the fixes of each track in the order of their times (TrackTimes.h). Errors: there is no fix at
    /// all; with the first problem.
    foundation::Result<TrackReading> finish();

private:
    std::string _name;
    TrackReading _reading;
    std::vector<std::pair<std::size_t, std::size_t>> _parts; ///< the track, and the first fix of the part
};

/// Takes the first line off a text, without its end: a line feed, returns and a line feed, or a return alone.
std::string_view takeLine(std::string_view& text);

/// Returns a text without blanks at both ends.
std::string_view trimmed(std::string_view text);

} // namespace simulation
