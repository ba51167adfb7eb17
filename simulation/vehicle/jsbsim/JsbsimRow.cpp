// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/jsbsim/JsbsimRow.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

namespace simulation
{
namespace
{

std::vector<std::string_view> cellsOf(std::string_view line)
{
    std::vector<std::string_view> cells;
    const auto isBlank = [](char c) { return c == ' ' || c == '\r' || c == '\t'; };
    for (std::size_t at = 0; at <= line.size();)
    {
        const std::size_t end = std::min(line.find(',', at), line.size());
        std::string_view cell = line.substr(at, end - at);
        while (!cell.empty() && isBlank(cell.front()))
            cell.remove_prefix(1);
        while (!cell.empty() && isBlank(cell.back()))
            cell.remove_suffix(1);
        cells.push_back(cell);
        at = end + 1;
    }
    return cells;
}

/// Whether a caption names a property: by itself or below the node that FlightGear's JSBSim puts before it,
/// with or without the number of the first of several.
bool isCaptionOf(std::string_view caption, std::string_view property)
{
    constexpr std::string_view kPrefix = "/fdm/jsbsim/", kFirst = "[0]";
    if (caption.starts_with(kPrefix)) caption.remove_prefix(kPrefix.size());
    const std::size_t first = caption.find(kFirst);
    if (first == std::string_view::npos) return caption == property;
    return std::string(caption.substr(0, first)).append(caption.substr(first + kFirst.size())) == property;
}

} // namespace

bool JsbsimRow::isFinite() const
{
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

std::optional<JsbsimTable> JsbsimTable::create(std::string_view captions,
                                               const std::vector<std::string>& more)
{
    JsbsimTable table;
    const std::vector<std::string_view> cells = cellsOf(captions);
    if (cells.front() != "Time") return std::nullopt;
    const auto placeOf = [&](std::string_view property)
    {
        const auto found = std::find_if(cells.begin(), cells.end(),
                                        [&](std::string_view cell) { return isCaptionOf(cell, property); });
        return found == cells.end() ? -1 : static_cast<int>(found - cells.begin());
    };
    table._count = static_cast<int>(cells.size());
    for (std::size_t i = 1; i < kJsbsimColumns; ++i)
    {
        table._places[i] = placeOf(kJsbsimProperties[i]);
        if (table._places[i] < 0 && i <= static_cast<std::size_t>(JsbsimColumn::last)) return std::nullopt;
    }
    for (const std::string& property : more)
        table._more.push_back(placeOf(property));
    return table;
}

std::optional<JsbsimRow> JsbsimTable::read(std::string_view line) const
{
    const std::vector<std::string_view> cells = cellsOf(line);
    if (static_cast<int>(cells.size()) != _count) return std::nullopt;
    const auto numberAt = [&](int place)
    {
        const std::string_view cell = cells[static_cast<std::size_t>(place)];
        double number = 0.0;
        const auto [end, failed] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
        return failed == std::errc() && end == cell.data() + cell.size() ? std::optional(number)
                                                                         : std::nullopt;
    };
    JsbsimRow row;
    for (std::size_t i = 0; i < kJsbsimColumns; ++i)
    {
        if (_places[i] < 0) continue;
        const std::optional<double> number = numberAt(_places[i]);
        if (!number) return std::nullopt;
        row.values[i] = *number;
    }
    for (const int place : _more)
        row.more.push_back(place < 0 ? std::nullopt : numberAt(place));
    return row;
}

} // namespace simulation
