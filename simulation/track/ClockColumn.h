// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// Finds out whether the plain numbers in a column of times are clocks: 101530.20 is 10:15:30.2, as
/// receivers of satellites (NMEA 0183) and recorders such as Columbus' write it.
/// They are where the name says so (`hhmmss`), and where all have six digits before the point, as hours,
/// minutes and seconds may be, and the name (`utc`, `gmt`, `time of day`, `clock`, `local time`), a column of
/// dates beside it or a number that begins with 0 shows that they are no seconds of a clock that only
/// counts. What only looks like a clock stays seconds, which is told.
class ClockColumn
{
public:
    /// `name`: of the column. `hasDates`: another one has dates.
    ClockColumn(std::string_view name, bool hasDates);

    /// Takes the cell of the next fix, and the seconds since 1970 at which its day begins.
    void take(std::string_view cell, double dayS);

    /// Gives all fixes that were taken their times of the day. False: they are no clocks, and nothing was
    /// done.
    bool set(std::vector<TrackFix>& fixes) const;

    /// What is to be told of numbers that set() leaves; empty: nothing.
    std::string doubt() const;

private:
    bool _isNamed = false, _isHint = false; ///< hhmmss; a name or a date that suits a clock
    bool _isSixDigits = true, _isClock = true, _hasZero = false;
    std::string _name, _first;
    std::vector<double> _times;
};

/// Returns the seconds since midnight of hhmmss with a fraction or without, of one to six digits; nothing
/// where it is none.
std::optional<double> secondsOfClockDigits(std::string_view text);

} // namespace simulation
