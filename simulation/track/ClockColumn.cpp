// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/ClockColumn.h"

#include <algorithm>
#include <initializer_list>

#include "simulation/parser/Expression.h"
#include "simulation/track/HeadingWords.h"
#include "simulation/track/TrackBuilder.h"

namespace simulation
{
namespace
{

constexpr std::size_t kClockDigits = 6;

/// How many digits a number has before its point.
std::size_t leadingDigits(std::string_view text)
{
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), isDigit) - text.begin());
}

bool hasAny(const std::vector<std::string>& words, std::initializer_list<std::string_view> wanted)
{
    return std::find_first_of(words.begin(), words.end(), wanted.begin(), wanted.end()) != words.end();
}

} // namespace

std::optional<double> secondsOfClockDigits(std::string_view text)
{
    text = trimmed(text);
    const std::size_t digits = leadingDigits(text);
    if (digits == 0 || digits > kClockDigits) return std::nullopt;
    std::string rest(text.substr(digits));
    if (!rest.empty() && rest.front() != '.' && rest.front() != ',') return std::nullopt;
    if (leadingDigits(std::string_view(rest).substr(rest.empty() ? 0 : 1)) + 1 < rest.size())
        return std::nullopt;
    if (!rest.empty()) rest.front() = '.';
    const std::string whole = std::string(kClockDigits - digits, '0') + std::string(text.substr(0, digits));
    const auto two = [&](std::size_t at)
    { return 10.0 * (whole[at] - '0') + static_cast<double>(whole[at + 1] - '0'); };
    if (two(0) >= 24.0 || two(2) >= 60.0 || two(4) >= 61.0) return std::nullopt; // a second may be added
    const auto fraction = rest.size() > 1 ? parseNumber("0" + rest) : std::optional(0.0);
    if (!fraction) return std::nullopt;
    return 3600.0 * two(0) + 60.0 * two(2) + two(4) + *fraction;
}

ClockColumn::ClockColumn(std::string_view name, bool hasDates) : _isHint(hasDates), _name(name)
{
    const auto words = inEnglish(headingWords(name));
    _isNamed = hasAny(words, {"hhmmss", "hms"});
    _isHint = _isHint || hasAny(words, {"utc", "gmt", "tod", "day", "clock", "local", "zulu"});
}

void ClockColumn::take(std::string_view cell, double dayS)
{
    cell = trimmed(cell);
    if (_times.empty()) _first = cell;
    const auto seconds = secondsOfClockDigits(cell);
    _isClock = _isClock && seconds.has_value();
    _isSixDigits = _isSixDigits && leadingDigits(cell) == kClockDigits;
    _hasZero = _hasZero || cell.starts_with('0');
    _times.push_back(dayS + seconds.value_or(0.0));
}

bool ClockColumn::set(std::vector<TrackFix>& fixes) const
{
    const bool isClock = _isClock && (_isNamed || (_isSixDigits && (_isHint || _hasZero)));
    if (!isClock || _times.empty() || fixes.size() != _times.size()) return false;
    for (std::size_t i = 0; i < fixes.size(); ++i)
        fixes[i].timeS = _times[i];
    return true;
}

std::string ClockColumn::doubt() const
{
    if (!_isClock || !_isSixDigits || _times.empty()) return {};
    return "the times of the column " + _name + " (" + _first +
           ") look like hours, minutes and seconds, and are taken as seconds; call it hhmmss if they are";
}

} // namespace simulation
