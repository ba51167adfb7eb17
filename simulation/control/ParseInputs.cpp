// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <foundation/Excerpt.h>
#include <foundation/LineCells.h>
#include <foundation/WholeText.h>

#include "simulation/control/InputTrack.h"
#include "simulation/parser/Expression.h"

namespace simulation
{
namespace
{

constexpr std::size_t kMostColumns = 64;
constexpr int kMostStepsPerSecond = 100'000;
constexpr double kLargestInput = 1e9;
constexpr std::uintmax_t kMostInputBytes = 256u << 20;

/// Reads an inputs file line by line.
class InputReader
{
public:
    explicit InputReader(const std::string& name) : _name(name) {}

    foundation::Outcome take(std::string_view line)
    {
        ++_line;
        const std::vector<std::string_view> cells = foundation::lineCells(line);
        if (cells.empty()) return foundation::success();
        if (!_isKnown) return takeFirst(cells);
        if (_track.end) return wrong("text after the line 'end'", "remove it, or move 'end' down");
        if (cells[0] == "rate") return takeRate(cells);
        if (cells[0] == "ramped" && cells.size() == 1) return takeRamped();
        if (cells[0] == "columns") return takeColumns(cells);
        if (cells[0] == "end") return takeEnd(cells);
        return takeRow(cells);
    }

    foundation::Result<InputTrack> finish()
    {
        if (!_isKnown) return foundation::Error{_name, "is empty", "begin it with 'osgtrainer-inputs 1'"};
        if (_track.rows.empty())
            return foundation::Error{_name, "has no row of inputs", "add one for step or time 0"};
        return std::move(_track);
    }

private:
    foundation::Error wrong(const std::string& what, const std::string& remedy) const
    {
        return {_name + ":" + std::to_string(_line), what, remedy};
    }

    foundation::Outcome takeFirst(const std::vector<std::string_view>& cells)
    {
        _isKnown = cells.size() == 2 && cells[0] == "osgtrainer-inputs" && cells[1] == "1";
        if (_isKnown) return foundation::success();
        return wrong("is no file of inputs of version 1", "begin it with 'osgtrainer-inputs 1'");
    }

    foundation::Outcome takeRate(const std::vector<std::string_view>& cells)
    {
        const auto rate = cells.size() == 2 ? parseNumber(cells[1]) : std::nullopt;
        if (!rate || *rate < 1.0 || *rate > kMostStepsPerSecond || *rate != std::floor(*rate) || _hasColumns)
            return wrong("'rate' is wrong here",
                         "write 'rate N' once, before 'columns', N a whole number of steps a second");
        _track.stepsPerSecond = static_cast<int>(*rate);
        return foundation::success();
    }

    foundation::Outcome takeRamped()
    {
        if (_hasColumns) return wrong("'ramped' stands below 'columns'", "move it up");
        _track.isRamped = true;
        return foundation::success();
    }

    foundation::Outcome takeColumns(const std::vector<std::string_view>& cells)
    {
        if (_hasColumns) return wrong("'columns' stands twice", "remove one of them");
        const std::string_view first = _track.stepsPerSecond > 0 ? "step" : "time";
        if (cells.size() < 2 || cells[1] != first)
            return wrong("the first column is not '" + std::string(first) + "'",
                         "with 'rate' rows begin with 'step', without it with 'time'");
        if (cells.size() < 3 || cells.size() > kMostColumns + 2)
            return wrong("there are no inputs, or more than " + std::to_string(kMostColumns),
                         "name them: columns " + std::string(first) + " elevator throttle");
        for (std::size_t i = 2; i < cells.size(); ++i)
        {
            if (std::find(_track.names.begin(), _track.names.end(), cells[i]) != _track.names.end())
                return wrong("the input '" + foundation::excerpt(cells[i]) + "' stands twice", "remove one");
            _track.names.emplace_back(cells[i]);
        }
        _hasColumns = true;
        return foundation::success();
    }

    foundation::Outcome takeEnd(const std::vector<std::string_view>& cells)
    {
        const auto end = cells.size() == 2 ? parseNumber(cells[1]) : std::nullopt;
        if (!end || _track.rows.empty() || *end < _track.rows.back().at)
            return wrong("'end' is wrong here",
                         "write 'end N' below the rows, N not before the last of them");
        _track.end = *end;
        return foundation::success();
    }

    foundation::Outcome takeRow(const std::vector<std::string_view>& cells)
    {
        if (!_hasColumns)
            return wrong("'" + foundation::excerpt(cells[0]) + "' is no word of the head",
                         "write rate, ramped or columns, and rows below columns");
        if (cells.size() != _track.names.size() + 1)
            return wrong(std::to_string(cells.size()) + " cells, but " +
                             std::to_string(_track.names.size() + 1) + " columns",
                         "write a number or - for each column");
        const auto at = parseNumber(cells[0]);
        if (!at || *at < 0.0 || (!_track.rows.empty() && *at <= _track.rows.back().at))
            return wrong("'" + foundation::excerpt(cells[0]) + "' is not after the row above",
                         "write rows in ascending order, from 0 on");
        if (_track.stepsPerSecond > 0 && *at != std::floor(*at))
            return wrong("'" + foundation::excerpt(cells[0]) + "' is no whole step",
                         "leave 'rate' out to write seconds");
        InputTrack::Row row{*at, {}};
        for (std::size_t i = 1; i < cells.size(); ++i)
        {
            const auto value = parseNumber(cells[i]);
            if (value ? std::abs(*value) > kLargestInput : cells[i] != "-")
                return wrong("'" + foundation::excerpt(cells[i]) + "' is no number that an input can have",
                             "write a number or -");
            row.values.push_back(value                 ? *value
                                 : _track.rows.empty() ? kInputNotGiven
                                                       : _track.rows.back().values[i - 1]);
        }
        _track.rows.push_back(std::move(row));
        return foundation::success();
    }

    const std::string& _name;
    InputTrack _track;
    std::size_t _line = 0;
    bool _isKnown = false, _hasColumns = false;
};

} // namespace

foundation::Result<InputTrack> parseInputs(std::string_view text, const std::string& name)
{
    InputReader reader(name);
    while (!text.empty())
    {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (const auto taken = reader.take(text.substr(0, end)); !taken) return taken.error();
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader.finish();
}

foundation::Result<InputTrack> readInputs(const std::filesystem::path& file)
{
    const auto text = foundation::readWholeText(file, kMostInputBytes);
    if (!text) return text.error();
    return parseInputs(*text, file.string());
}

} // namespace simulation
