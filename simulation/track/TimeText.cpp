// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TimeText.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string>

#include "simulation/environment/DateTime.h"
#include "simulation/parser/Expression.h"
#include "simulation/track/TrackBuilder.h"

namespace simulation
{
namespace
{

constexpr std::size_t kDateLength = 10;
constexpr double kDayS = 86400.0;

/// The parts of a text between marks.
std::vector<std::string_view> partsOf(std::string_view text, std::string_view marks)
{
    std::vector<std::string_view> parts;
    for (;;)
    {
        const std::size_t end = std::min(text.find_first_of(marks), text.size());
        parts.push_back(text.substr(0, end));
        if (end == text.size()) return parts;
        text.remove_prefix(end + 1);
    }
}

bool isNumber(std::string_view text)
{
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// A date as year-month-day, also of 20260417; empty: it is none. Of 13/04/2026 the first is the day, of
/// 03/04/2026 the month, unless `isDayFirst`.
std::string isoDate(std::string_view text, bool isDayFirst)
{
    constexpr std::size_t kDigitsAlone = 8; // 20260417
    if (text.size() == kDigitsAlone && isNumber(text) && (text.starts_with("19") || text.starts_with("20")))
        return std::string(text.substr(0, 4)) + "-" + std::string(text.substr(4, 2)) + "-" +
               std::string(text.substr(6));
    const std::vector<std::string_view> parts = partsOf(text, "-/.");
    if (parts.size() != 3 || !std::all_of(parts.begin(), parts.end(), isNumber)) return {};
    std::string_view year = parts[0], month = parts[1], day = parts[2];
    if (parts[0].size() != 4)
    {
        year = parts[2];
        const bool isMonthFirst = !isDayFirst && text.find('/') != std::string_view::npos && parts[0] <= "12";
        month = parts[isMonthFirst ? 0 : 1];
        day = parts[isMonthFirst ? 1 : 0];
    }
    if (year.size() != 4 || month.size() > 2 || day.size() > 2) return {};
    const auto two = [](std::string_view number)
    { return number.size() < 2 ? "0" + std::string(number) : std::string(number); };
    return std::string(year) + "-" + two(month) + "-" + two(day);
}

std::optional<double> parsed(const std::string& text)
{
    const auto time = parseDateTime(text);
    if (!time) return std::nullopt;
    return static_cast<double>(time->unixMilliseconds) / 1000.0;
}

/// Puts the words of a zone into the form of ISO 8601.
void tidyZone(std::string& text)
{
    for (const char* word : {" UTC", " GMT", " Z", "UTC", "GMT", "z"})
        if (text.ends_with(word))
        {
            text.replace(text.size() - std::string_view(word).size(), std::string::npos, "Z");
            break;
        }
    const std::size_t sign = text.find_first_of("+-", std::min(kDateLength, text.size()));
    if (sign == std::string::npos) return;
    if (sign > 0 && text[sign - 1] == ' ') return tidyZone(text.erase(sign - 1, 1));
    if (text.size() == sign + 3) text += ":00";
}

} // namespace

std::optional<double> unixSecondsOfDate(std::string_view text, bool isDayFirst)
{
    const std::string date = isoDate(trimmed(text), isDayFirst);
    return date.empty() ? std::nullopt : parsed(date + "T00:00:00Z");
}

std::optional<double> unixSeconds(std::string_view written, bool isDayFirst)
{
    written = trimmed(written);
    const std::size_t end = std::min(written.find_first_of("Tt "), written.size());
    const std::string date = isoDate(written.substr(0, end), isDayFirst);
    if (date.empty() || end == written.size()) return std::nullopt;
    std::string text = date + "T" + std::string(trimmed(written.substr(end + 1)));
    std::replace(text.begin(), text.end(), ',', '.');
    const auto day = unixSecondsOfDate(date), atDay = secondsOfDay(text.substr(kDateLength + 1));
    if (day && atDay && *atDay <= kDayS) return *day + *atDay; // an hour of one digit, AM, no zone
    tidyZone(text);
    return parsed(text);
}

std::optional<double> secondsOfDay(std::string_view text)
{
    text = trimmed(text);
    std::string tail;
    for (; !text.empty() && std::isalpha(static_cast<unsigned char>(text.back())); text.remove_suffix(1))
        tail.insert(tail.begin(), static_cast<char>(std::toupper(static_cast<unsigned char>(text.back()))));
    text = trimmed(text);
    if (!tail.empty() && tail != "AM" && tail != "PM") return std::nullopt;
    const std::vector<std::string_view> parts = partsOf(text, ":");
    if (parts.size() != 3 || !isNumber(parts[0]) || !isNumber(parts[1])) return std::nullopt;
    std::string last(parts[2]);
    std::replace(last.begin(), last.end(), ',', '.');
    const auto hours = parseNumber(parts[0]), minutes = parseNumber(parts[1]), seconds = parseNumber(last);
    if (!hours || !minutes || !seconds || *minutes >= 60.0 || !(*seconds >= 0.0 && *seconds < 61.0) ||
        last[0] == '+')
        return std::nullopt;
    double hour = *hours;
    if (tail == "AM" && hour == 12.0) hour = 0.0;
    if (tail == "PM" && hour < 12.0) hour += 12.0;
    return 3600.0 * hour + 60.0 * *minutes + *seconds;
}

} // namespace simulation
