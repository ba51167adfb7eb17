// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>

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
};

/// The names of the columns, in small letters; what follows a blank, a bracket or an underscore of a unit does not count.
const std::array<std::vector<std::string_view>, 4> kNames = {
    {{"time", "timestamp", "t", "datetime", "utc"},
     {"latitude", "lat"},
     {"longitude", "lon", "lng", "long"},
     {"height", "altitude", "alt", "elevation", "ele"}}};

std::vector<std::string_view> cellsOf(std::string_view line, char mark)
{
    std::vector<std::string_view> cells;
    for (std::size_t at = 0; at <= line.size();)
    {
        const std::size_t end = std::min(line.find(mark, at), line.size());
        std::string_view cell = trimmed(line.substr(at, end - at));
        if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
            cell = cell.substr(1, cell.size() - 2);
        cells.push_back(cell);
        at = end + 1;
    }
    return cells;
}

/// Which cell each column is in; -1: none.
std::array<int, 4> columnsOf(const std::vector<std::string_view>& cells)
{
    std::array<int, 4> columns{-1, -1, -1, -1};
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
    {
        std::string name(cells[cell].substr(0, cells[cell].find_first_of(" ([_")));
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        for (std::size_t column = 0; column < kNames.size(); ++column)
            if (columns[column] < 0 &&
                std::find(kNames[column].begin(), kNames[column].end(), name) != kNames[column].end())
                columns[column] = static_cast<int>(cell);
    }
    return columns;
}

std::optional<double> timeOf(std::string_view cell)
{
    if (const auto seconds = parseNumber(cell)) return seconds;
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
    const std::string_view header = takeLine(text);
    const char mark = header.find(';') != std::string_view::npos    ? ';'
                      : header.find('\t') != std::string_view::npos ? '\t'
                                                                    : ',';
    const std::array<int, 4> columns = columnsOf(cellsOf(header, mark));
    if (columns[kLatitude] < 0 || columns[kLongitude] < 0)
        return foundation::Error{name + ":1", "the first line names no columns for latitude and longitude",
                                 "begin with a line such as time,latitude,longitude,height"};
    TrackBuilder builder(name);
    FlightTrack& track = builder.begin(name, HeightDatum::meanSeaLevel);
    track.hasTimes = columns[kTime] >= 0;
    for (int line = 2; !text.empty(); ++line)
    {
        const std::vector<std::string_view> cells = cellsOf(takeLine(text), mark);
        if (cells.size() == 1 && cells.front().empty()) continue;
        const auto cell = [&](Column column) -> std::string_view
        {
            const auto at = static_cast<std::size_t>(columns[column]);
            return columns[column] >= 0 && at < cells.size() ? cells[at] : std::string_view{};
        };
        const auto latitude = parseNumber(cell(kLatitude)), longitude = parseNumber(cell(kLongitude));
        const auto time = track.hasTimes ? timeOf(cell(kTime)) : std::optional(0.0);
        const auto height = parseNumber(cell(kHeight));
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
