// SPDX-License-Identifier: Apache-2.0
#include "simulation/record/MotionTable.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <foundation/CsvCells.h>
#include <foundation/Utf8.h>
#include <zlib.h>

#include "simulation/parser/Expression.h"

namespace simulation
{
namespace
{

constexpr std::size_t kMostTableBytes = std::size_t{1} << 30;

foundation::Result<std::string> unpackedTable(const std::filesystem::path& file)
{
    std::error_code ignored;
    const gzFile stream =
        std::filesystem::is_regular_file(file, ignored) ? gzopen(file.c_str(), "rb") : nullptr;
    if (!stream) return foundation::Error{file.string(), "no such file", "correct the name"};
    std::string text;
    std::array<char, 65536> chunk{};
    int count = 0;
    while (text.size() < kMostTableBytes &&
           (count = gzread(stream, chunk.data(), static_cast<unsigned>(chunk.size()))) > 0)
        text.append(chunk.data(), static_cast<std::size_t>(count));
    gzclose(stream);
    if (count < 0)
        return foundation::Error{file.string(), "the compressed file is damaged", "fetch it again"};
    if (text.size() >= kMostTableBytes)
        return foundation::Error{file.string(), "larger than 1 GiB", "write fewer rows"};
    return text;
}

/// The columns of one entity, counted from its name.
struct Layout
{
    std::size_t x = 0, y = 0, z = 0, heading = 0, speed = 0, width = 0;
    std::optional<std::size_t> lane, collisions, roll;
};

constexpr std::size_t kFirstEntity = 2; ///< after index and time

class Reader
{
public:
    explicit Reader(const std::string& name) : _name(name) {}

    foundation::Result<MotionTable> run(std::string_view text)
    {
        const auto read = foundation::Utf8Text::of(text, {}, _name);
        if (!read) return read.error();
        text = read->in(text);
        while (!text.empty() && !_error)
        {
            const bool isHeader = text.starts_with("Index");
            if (_layout.width == 0 && !isHeader) // lines of text
            {
                text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
                ++_line;
                continue;
            }
            const foundation::CsvRecord record = foundation::takeCsvRecord(text, ',');
            isHeader ? header(record.cells) : row(record.cells);
            _line += record.lines;
        }
        if (_error) return *_error;
        if (_layout.width == 0)
            return foundation::Error{_name, "no line begins with Index", "give a table of --csv_logger"};
        return std::move(_table);
    }

private:
    void header(const std::vector<std::string>& names)
    {
        const auto isOfFirst = [](const std::string& name) { return name.starts_with("#1 "); };
        _layout.width = static_cast<std::size_t>(std::count_if(names.begin(), names.end(), isOfFirst));
        const auto find = [&](const std::string& column, std::size_t& place)
        {
            const auto found =
                std::find_if(names.begin(), names.end(),
                             [&](const std::string& name) { return name.starts_with("#1 " + column); });
            const auto index = static_cast<std::size_t>(found - names.begin());
            if (found == names.end() || index < kFirstEntity)
                fail("there is no column " + column, "give a table of --csv_logger");
            else
                place = index - kFirstEntity;
        };
        find("Current_Speed", _layout.speed);
        find("World_Position_X", _layout.x);
        find("World_Position_Y", _layout.y);
        find("World_Position_Z", _layout.z);
        find("World_Heading_Angle", _layout.heading);
        const auto findOptional = [&](const std::string& column) -> std::optional<std::size_t>
        {
            const auto found =
                std::find_if(names.begin(), names.end(),
                             [&](const std::string& name) { return name.starts_with("#1 " + column); });
            if (found == names.end()) return std::nullopt;
            return static_cast<std::size_t>(found - names.begin()) - kFirstEntity;
        };
        _layout.lane = findOptional("lane_id");
        _layout.collisions = findOptional("collision_ids");
        _layout.roll = findOptional("World_Roll_Angle");
    }

    void row(const std::vector<std::string>& cells)
    {
        if (cells.size() < kFirstEntity) return; // an empty line
        const double time = number(cells[1]);
        if (!_table.timeS.empty() && time < _table.timeS.back()) fail("the time falls", "sort the rows");
        for (MotionTrack& track : _table.tracks)
            track.samples.emplace_back();
        _table.timeS.push_back(time);
        for (std::size_t at = kFirstEntity; at < cells.size() && !cells[at].empty() && !_error;
             at += _layout.width)
        {
            if (at + _layout.heading >= cells.size()) return fail("the row ends early", "complete it");
            trackOf(cells[at]).samples.back() = MotionSample{
                {number(cells[at + _layout.x]), number(cells[at + _layout.y]), number(cells[at + _layout.z])},
                number(cells[at + _layout.heading]),
                number(cells[at + _layout.speed]),
                _layout.lane && at + *_layout.lane < cells.size()
                    ? static_cast<int>(number(cells[at + *_layout.lane]))
                    : 0,
                _layout.collisions && at + *_layout.collisions < cells.size() &&
                    !cells[at + *_layout.collisions].empty(),
                _layout.roll && at + *_layout.roll < cells.size()
                    ? std::optional(number(cells[at + *_layout.roll]))
                    : std::nullopt};
        }
    }

    MotionTrack& trackOf(const std::string& entity)
    {
        for (MotionTrack& track : _table.tracks)
            if (track.entity == entity) return track;
        _table.tracks.push_back({entity, {}});
        _table.tracks.back().samples.resize(_table.timeS.size());
        return _table.tracks.back();
    }

    double number(const std::string& cell)
    {
        if (const std::optional<double> value = parseNumber(cell)) return *value;
        fail("\"" + cell.substr(0, 40) + "\" is not a finite number", "correct the cell");
        return 0.0;
    }

    void fail(const std::string& what, const std::string& remedy)
    {
        if (!_error) _error = foundation::Error{_name + ":" + std::to_string(_line), what, remedy};
    }

    const std::string& _name;
    int _line = 1;
    Layout _layout;
    MotionTable _table;
    std::optional<foundation::Error> _error;
};

} // namespace

const MotionTrack* MotionTable::find(const std::string& entity) const
{
    for (const MotionTrack& track : tracks)
        if (track.entity == entity) return &track;
    return nullptr;
}

foundation::Result<MotionTable> readMotionTable(const std::filesystem::path& file)
{
    const foundation::Result<std::string> text = unpackedTable(file);
    if (!text) return text.error();
    return parseMotionTable(*text, file.string());
}

foundation::Result<MotionTable> parseMotionTable(const std::string& text, const std::string& name)
{
    return Reader(name).run(text);
}

} // namespace simulation
