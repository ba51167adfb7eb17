// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <foundation/Units.h>

#include "simulation/environment/DateTime.h"
#include "simulation/parser/Expression.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TrackBuilder.h"

namespace simulation
{
namespace
{

enum Column
{
    kTime,
    kLatitude,
    kLongitude,
    kHeight,
    kPosition, ///< latitude and longitude in one cell
    kColumns
};

constexpr double kMilliseconds = 1e11; ///< since 1970: more seconds than 3000 years have

/// The names of the columns, in small letters.
const std::array<std::vector<std::string_view>, kColumns> kNames = {
    {{"time", "timestamp", "t", "datetime", "utc"},
     {"latitude", "lat"},
     {"longitude", "lon", "lng", "long"},
     {"height", "altitude", "alt", "elevation", "ele", "geoaltitude", "baroaltitude"},
     {"position"}}};

/// The cells of a line; a mark between quotes is part of its cell.
std::vector<std::string_view> cellsOf(std::string_view line, char mark)
{
    std::vector<std::string_view> cells;
    for (std::size_t at = 0; at <= line.size();)
    {
        std::size_t end = at;
        for (bool isQuoted = false; end < line.size() && (isQuoted || line[end] != mark); ++end)
            if (line[end] == '"') isQuoted = !isQuoted;
        std::string_view cell = trimmed(line.substr(at, end - at));
        if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
            cell = cell.substr(1, cell.size() - 2);
        cells.push_back(cell);
        at = end + 1;
    }
    return cells;
}

/// The words of a column's name, in small letters: letters in a row.
std::vector<std::string> wordsOf(std::string_view name)
{
    std::vector<std::string> words(1);
    for (const char c : name)
    {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalpha(letter))
            words.back() += static_cast<char>(std::tolower(letter));
        else if (!words.back().empty())
            words.emplace_back();
    }
    return words;
}

/// Which cell each column is in; -1: none. By the first word of its name, else by one of the others
/// (`gps_latitude`).
std::array<int, kColumns> columnsOf(const std::vector<std::string_view>& cells)
{
    std::array<int, kColumns> columns;
    columns.fill(-1);
    for (const bool isByFirst : {true, false})
        for (std::size_t cell = 0; cell < cells.size(); ++cell)
        {
            std::vector<std::string> words = wordsOf(cells[cell]);
            if (isByFirst) words.resize(1);
            for (std::size_t column = 0; column < kNames.size(); ++column)
                if (columns[column] < 0 &&
                    std::find_first_of(words.begin(), words.end(), kNames[column].begin(),
                                       kNames[column].end()) != words.end())
                    columns[column] = static_cast<int>(cell);
        }
    return columns;
}

/// Whether a column counts in feet: its name says so, or it is one of Flightradar24's tables, which have a
/// position in one cell.
bool isInFeet(const std::array<int, kColumns>& columns, const std::vector<std::string_view>& cells)
{
    if (columns[kHeight] < 0) return false;
    const auto words = wordsOf(cells[static_cast<std::size_t>(columns[kHeight])]);
    return columns[kPosition] >= 0 || std::any_of(words.begin(), words.end(),
                                                  [](const std::string& word) {
                                                      return word == "ft" || word == "feet" || word == "foot";
                                                  });
}

/// Parts a cell with both coordinates in two.
std::pair<std::string_view, std::string_view> partedAtComma(std::string_view cell)
{
    const std::size_t comma = std::min(cell.find(','), cell.size());
    return {trimmed(cell.substr(0, comma)), trimmed(cell.substr(std::min(comma + 1, cell.size())))};
}

/// The seconds of a time of day, h:m:s.
std::optional<double> timeOfDay(std::string_view cell)
{
    double seconds = 0.0;
    int parts = 0;
    for (; !cell.empty(); ++parts)
    {
        const std::size_t end = std::min(cell.find(':'), cell.size());
        const auto part = parseNumber(cell.substr(0, end));
        if (!part || *part < 0.0) return std::nullopt;
        seconds = 60.0 * seconds + *part;
        cell = cell.substr(std::min(end + 1, cell.size()));
    }
    return parts == 3 ? std::optional(seconds) : std::nullopt;
}

std::optional<double> timeOf(std::string_view cell)
{
    if (const auto seconds = parseNumber(cell))
        return *seconds > kMilliseconds ? *seconds / 1000.0 : *seconds;
    if (const auto seconds = timeOfDay(cell)) return seconds;
    std::string text(cell);
    if (text.size() > 10 && text[10] == ' ') text[10] = 'T';
    const auto time = parseDateTime(text);
    if (!time) return std::nullopt;
    return static_cast<double>(time->unixMilliseconds) / 1000.0;
}

} // namespace

foundation::Result<TrackReading> parseTrackTable(std::string_view text, const std::string& name)
{
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::string_view header = takeLine(text);
    int line = 1;
    for (; !text.empty() && (trimmed(header).empty() || trimmed(header).starts_with('#')); ++line)
        header = takeLine(text);
    const char mark = header.find(';') != std::string_view::npos    ? ';'
                      : header.find('\t') != std::string_view::npos ? '\t'
                                                                    : ',';
    const auto names = cellsOf(header, mark);
    std::array<int, kColumns> columns = columnsOf(names);
    if (columns[kLatitude] >= 0 && columns[kLongitude] >= 0) columns[kPosition] = -1;
    if ((columns[kLatitude] < 0 || columns[kLongitude] < 0) && columns[kPosition] < 0)
        return foundation::Error{name + ":" + std::to_string(line),
                                 "the first line names no columns for latitude and longitude",
                                 "begin with a line such as time,latitude,longitude,height"};
    const double unitM = isInFeet(columns, names) ? foundation::kMetresPerFoot : 1.0;
    TrackBuilder builder(name);
    FlightTrack& track = builder.begin(name, HeightDatum::meanSeaLevel);
    track.hasTimes = columns[kTime] >= 0;
    for (++line; !text.empty(); ++line)
    {
        const std::vector<std::string_view> cells = cellsOf(takeLine(text), mark);
        if (cells.size() == 1 && cells.front().empty()) continue;
        const auto cell = [&](Column column) -> std::string_view
        {
            const auto at = static_cast<std::size_t>(columns[column]);
            return columns[column] >= 0 && at < cells.size() ? cells[at] : std::string_view{};
        };
        const auto [north, east] = columns[kPosition] >= 0 ? partedAtComma(cell(kPosition))
                                                           : std::pair(cell(kLatitude), cell(kLongitude));
        const auto latitude = parseNumber(north), longitude = parseNumber(east);
        const auto time = track.hasTimes ? timeOf(cell(kTime)) : std::optional(0.0);
        auto height = parseNumber(cell(kHeight));
        if (height) *height *= unitM;
        if (!latitude || !longitude)
            builder.problem(line, "latitude or longitude is no number");
        else if (!time)
            builder.problem(line, "the time is neither seconds nor a date and time");
        else if (!height && !cell(kHeight).empty())
            builder.problem(line, "the height is no number");
        else
            builder.add(track, {*time, *latitude, *longitude, height, line});
    }
    return builder.finish();
}

} // namespace simulation
