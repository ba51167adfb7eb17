// SPDX-License-Identifier: Apache-2.0
#include "simulation/environment/DateTime.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace simulation
{
namespace
{

constexpr std::int64_t kMillisecondsPerDay = 86'400'000;

/// Reads fixed-width fields from the front of a text and remembers the first failure.
class FieldReader
{
public:
    explicit FieldReader(std::string_view text) : _text(text) {}

    int number(std::size_t width)
    {
        if (_text.size() < width)
        {
            _ok = false;
            return 0;
        }
        int value = 0;
        for (std::size_t i = 0; i < width; ++i)
        {
            if (_text[i] < '0' || _text[i] > '9') _ok = false;
            value = value * 10 + (_text[i] - '0');
        }
        _text.remove_prefix(width);
        return value;
    }

    bool accept(char wanted)
    {
        if (_text.empty() || _text.front() != wanted) return false;
        _text.remove_prefix(1);
        return true;
    }

    void expect(char wanted) { _ok = accept(wanted) && _ok; }

    /// Digits after the point as milliseconds; further digits are dropped.
    int milliseconds()
    {
        int value = 0;
        int digits = 0;
        for (; !_text.empty() && _text.front() >= '0' && _text.front() <= '9'; ++digits)
        {
            if (digits < 3) value = value * 10 + (_text.front() - '0');
            _text.remove_prefix(1);
        }
        if (digits == 0) _ok = false;
        for (; digits < 3; ++digits)
            value *= 10;
        return value;
    }

    bool isDone() const { return _ok && _text.empty(); }

private:
    std::string_view _text;
    bool _ok = true;
};

int zoneMinutes(FieldReader& fields)
{
    if (fields.accept('Z')) return 0;
    const bool west = fields.accept('-');
    if (!west && !fields.accept('+')) return 0;
    const int hours = fields.number(2);
    fields.accept(':'); // 1.0 files write +0200
    const int minutes = hours * 60 + fields.number(2);
    return west ? -minutes : minutes;
}

} // namespace

DateTime DateTime::plusSeconds(double seconds) const
{
    return {unixMilliseconds + static_cast<std::int64_t>(std::llround(seconds * 1000.0))};
}

double DateTime::julianDay() const
{
    return static_cast<double>(unixMilliseconds) / static_cast<double>(kMillisecondsPerDay) + 2440587.5;
}

std::optional<DateTime> parseDateTime(std::string_view text)
{
    FieldReader fields(text);
    const int year = fields.number(4);
    fields.expect('-');
    const int month = fields.number(2);
    fields.expect('-');
    const int day = fields.number(2);
    fields.expect('T');
    const int hour = fields.number(2);
    fields.expect(':');
    const int minute = fields.number(2);
    fields.expect(':');
    const int second = fields.number(2);
    const int millisecond = fields.accept('.') ? fields.milliseconds() : 0;
    const int zone = zoneMinutes(fields);
    const std::chrono::year_month_day date{std::chrono::year{year},
                                           std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    if (!fields.isDone() || year < 1 || !date.ok()) return std::nullopt;
    if (hour > 24 || minute > 59 || second > 60 || std::abs(zone) > 14 * 60) return std::nullopt;
    const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
    const std::int64_t seconds = (hour * 60LL + minute - zone) * 60LL + second;
    return DateTime{days * kMillisecondsPerDay + seconds * 1000 + millisecond};
}

std::string formatDateTime(const DateTime& dateTime)
{
    std::int64_t days = dateTime.unixMilliseconds / kMillisecondsPerDay;
    std::int64_t rest = dateTime.unixMilliseconds % kMillisecondsPerDay;
    if (rest < 0)
    {
        rest += kMillisecondsPerDay;
        --days;
    }
    const std::chrono::year_month_day date{std::chrono::sys_days(std::chrono::days(days))};
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ",
                  static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                  static_cast<unsigned>(date.day()), static_cast<int>(rest / 3'600'000),
                  static_cast<int>(rest / 60'000 % 60), static_cast<int>(rest / 1000 % 60),
                  static_cast<int>(rest % 1000));
    return text.data();
}

} // namespace simulation
