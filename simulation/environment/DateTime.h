// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace simulation
{

/// An instant, UTC, on the proleptic Gregorian calendar without leap seconds.
/// Units: milliseconds since 1970-01-01T00:00:00Z.
struct DateTime
{
    std::int64_t unixMilliseconds = 0;

    bool operator==(const DateTime&) const = default;

    DateTime plusSeconds(double seconds) const;

    /// Days since noon, 1 January 4713 BC (Julian day number with fraction).
    double julianDay() const;
};

/// Reads an xsd:dateTime such as 2025-06-13T06:00:00.000+02:00, years 1 to 9999. A missing zone means UTC.
/// Returns nothing for other text and for an impossible date.
std::optional<DateTime> parseDateTime(std::string_view text);

/// Writes an instant in UTC with milliseconds: 2025-06-13T04:00:00.000Z.
std::string formatDateTime(const DateTime& dateTime);

} // namespace simulation
