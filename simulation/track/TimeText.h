// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace simulation
{

/// Returns the seconds since 1970 of a date and time as recorders write it: ISO 8601, also with a blank in
/// place of the T, slashes in the date, a comma before the fraction, hours alone as its zone, or UTC or GMT
/// behind it; else day.month.year or month/day/year (`isDayFirst`: day/month/year) and the
/// time. Without a zone it is UTC. Nothing where it
/// cannot be read.
std::optional<double> unixSeconds(std::string_view text, bool isDayFirst = false);

/// Returns the seconds since midnight of h:m:s, with a fraction and with AM or PM or without; nothing where
/// it is none.
std::optional<double> secondsOfDay(std::string_view text);

/// Returns the seconds since 1970 at which a day begins, written as in unixSeconds(); nothing where it is
/// none.
std::optional<double> unixSecondsOfDate(std::string_view text, bool isDayFirst = false);

} // namespace simulation
