// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <foundation/CsvCells.h>
#include <foundation/Units.h>
#include <foundation/Utf8.h>

#include "simulation/track/CellNumber.h"
#include "simulation/track/ClockColumn.h"
#include "simulation/track/CoordinateText.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TableColumns.h"
#include "simulation/track/TableMotion.h"
#include "simulation/track/TableObjects.h"
#include "simulation/track/TimeText.h"
#include "simulation/track/TrackBuilder.h"
#include "simulation/track/TrackTimes.h"

namespace simulation
{
namespace
{

constexpr double kMilliseconds = 1e11; ///< since 1970: more seconds than 3000 years have

/// Reads a height in metres. `unitM`: of a cell that names none.
std::optional<double> heightIn(std::string_view cell, bool isDecimalComma, double unitM)
{
    const auto number = cellNumber(cell, isDecimalComma);
    if (!number || !number->before.empty()) return std::nullopt;
    if (number->behind.empty()) return unitM * number->value;
    if (number->behind == "M") return number->value;
    if (number->behind == "FT" || number->behind == "FEET" || number->behind == "'")
        return foundation::kMetresPerFoot * number->value;
    return std::nullopt;
}

/// Parts a cell with both coordinates in two.
std::pair<std::string_view, std::string_view> partedAtComma(std::string_view cell)
{
    const std::size_t comma = std::min(cell.find(','), cell.size());
    return {trimmed(cell.substr(0, comma)), trimmed(cell.substr(std::min(comma + 1, cell.size())))};
}

/// Reads the rows of a table.
class TableReader
{
public:
    /// `names`: of the columns.
    TableReader(const std::string& name, const TableColumns& columns, std::vector<std::string> names)
        : _name(name),
          _columns(columns),
          _names(std::move(names)),
          _motion(_names),
          _clock(columns.time >= 0 ? std::string_view(_names[static_cast<std::size_t>(columns.time)])
                                   : std::string_view(),
                 columns.date >= 0),
          _builder(name)
    {
    }

    TrackBuilder& builder() { return _builder; }

    void take(const std::vector<std::string>& cells, int line)
    {
        const auto cell = [&](int column) -> std::string_view
        {
            const auto at = static_cast<std::size_t>(column);
            return column >= 0 && at < cells.size() ? std::string_view(cells[at]) : std::string_view{};
        };
        const auto [north, east] = _columns.position >= 0
                                       ? partedAtComma(cell(_columns.position))
                                       : std::pair(cell(_columns.latitude), cell(_columns.longitude));
        for (const std::string_view text : {north, east})
            if (text.find(',') != std::string_view::npos && text.find('.') == std::string_view::npos)
                _isDecimalComma = true;
        const CoordinateReading latitude = readCoordinate(north, false, {_columns.latitudeUnitDeg}),
                                longitude =
                                    readCoordinate(east, true, {_columns.longitudeUnitDeg, _columns.sideOfO});
        const auto time =
            _columns.time >= 0 ? timeOf(cell(_columns.time), cell(_columns.date)) : std::optional(0.0);
        const auto height = heightIn(cell(_columns.height), _isDecimalComma, _columns.heightUnitM);
        if (!latitude.degrees || !longitude.degrees)
        {
            const std::string& fault = latitude.degrees ? longitude.fault : latitude.fault;
            _builder.problem(line, fault.empty() ? "latitude or longitude is no number" : fault);
        }
        else if (!time)
            _builder.problem(line, "the time is neither seconds nor a date and time");
        else if (!height && !cell(_columns.height).empty())
            _builder.problem(line, "the height is no number");
        else
        {
            _fixes.push_back({*time, *latitude.degrees, *longitude.degrees, height, line});
            _motion.take(cells, _isDecimalComma, _fixes.back());
            _clock.take(cell(_columns.time), dayOf(cell(_columns.date)));
            _ids.emplace_back();
            for (const int column : _columns.ids)
                _ids.back().emplace_back(trimmed(cell(column)));
        }
    }

    foundation::Result<TrackReading> finish()
    {
        if (_columns.time >= 0 && _columns.timeUnitS == 1.0 && !_fixes.empty()) setClocks();
        const auto by = partingId(_ids);
        if (!by)
            addTrack(_name, _fixes);
        else
            addTracks(*by);
        return _builder.finish();
    }

private:
    /// Takes numbers such as 101530 as times of the day, or tells why not.
    void setClocks()
    {
        if (_clock.set(_fixes))
            _areTimesOfDay = true;
        else if (const std::string doubt = _clock.doubt(); !doubt.empty())
            _builder.note(1, doubt);
        if (_areTimesOfDay && !_strangeDate.empty())
            _builder.note(1, "the date " + _strangeDate +
                                 " cannot be read; write it as 2026-04-17, or the hour of the sun is off");
    }

    void addTrack(const std::string& name, std::vector<TrackFix>& fixes)
    {
        FlightTrack& track = _builder.begin(name, _columns.datum);
        track.hasTimes = _columns.time >= 0;
        if (_columns.isOfAircraft) track.kind = TrackKind::aircraft;
        if (_areTimesOfDay) addDays(fixes);
        for (const TrackFix& fix : fixes)
            _builder.add(track, fix);
        for (const std::string& note : _motion.settle(track))
            _builder.note(track.fixes.front().line, note);
    }

    /// A track for each object, in the order in which the file has them.
    void addTracks(std::size_t by)
    {
        std::map<std::string, std::size_t> places;
        std::vector<std::pair<std::string, std::vector<TrackFix>>> objects;
        for (std::size_t i = 0; i < _fixes.size(); ++i)
        {
            const std::string& id = _ids[i][by];
            if (id.empty())
            {
                _builder.problem(_fixes[i].line,
                                 "nothing in the column " + nameOf(by) + " tells whose row it is");
                continue;
            }
            const auto [place, isNew] = places.try_emplace(id, objects.size());
            if (isNew) objects.emplace_back(id, std::vector<TrackFix>{});
            objects[place->second].second.push_back(_fixes[i]);
        }
        constexpr double kHalfDayS = 43'200.0;
        const double firstS = _fixes.front().timeS;
        std::string told;
        for (std::size_t i = 0; i < objects.size(); ++i)
        {
            auto& [id, fixes] = objects[i];
            // One that is first seen after midnight is a day later than the others.
            if (_areTimesOfDay && fixes.front().timeS < firstS - kHalfDayS)
                for (TrackFix& fix : fixes)
                    fix.timeS += 2.0 * kHalfDayS;
            addTrack(id, fixes);
            constexpr std::size_t kTold = 8;
            if (i < kTold) told += (i > 0 ? ", " : "") + id;
            if (i == kTold) told += " ...";
        }
        _builder.note(1, std::to_string(objects.size()) + " tracks by the column " + nameOf(by) + ": " +
                             told + "; --eye-entity NAME looks from another one");
    }

    const std::string& nameOf(std::size_t by) const
    {
        return _names[static_cast<std::size_t>(_columns.ids[by])];
    }

    /// Seconds, milliseconds and so on since 1970 by their size; times of the day; dates and times.
    std::optional<double> timeOf(std::string_view cell, std::string_view date)
    {
        const auto number = cellNumber(cell, _isDecimalComma);
        if (number && number->before.empty() && number->behind.empty())
        {
            if (std::fabs(number->value) < kMilliseconds) return _columns.timeUnitS * number->value;
            if (number->value < 0.0) return std::nullopt;
            double seconds = number->value;
            while (seconds > kMilliseconds)
                seconds /= 1000.0;
            return seconds;
        }
        if (const auto seconds = secondsOfDay(cell))
        {
            _areTimesOfDay = true;
            return dayOf(date) + *seconds;
        }
        return unixSeconds(cell, _columns.isDayFirst);
    }

    /// Seconds since 1970 at which a day begins; 0 where no date is given that can be read.
    double dayOf(std::string_view date)
    {
        const auto day = unixSecondsOfDate(date, _columns.isDayFirst);
        if (!day && _strangeDate.empty()) _strangeDate = trimmed(date);
        return day.value_or(0.0);
    }

    const std::string& _name;
    const TableColumns& _columns;
    std::vector<std::string> _names;
    TableMotion _motion;
    ClockColumn _clock;
    TrackBuilder _builder;
    std::string _strangeDate; ///< the first that cannot be read
    std::vector<TrackFix> _fixes;
    std::vector<RowIds> _ids; ///< of each fix
    bool _isDecimalComma = false, _areTimesOfDay = false;
};

} // namespace

foundation::Result<TrackReading> parseTrackTable(std::string_view text, const std::string& name)
{
    const auto read = foundation::Utf8Text::of(text, {}, name);
    if (!read) return read.error();
    text = read->in(text);
    char mark = '\0';
    int line = 1;
    for (; !text.empty(); ++line)
    {
        std::string_view rest = text;
        const std::string_view header = trimmed(takeLine(rest));
        const bool isSeparator = header.starts_with("sep=") && header.size() == 5; // a line of Excel's
        if (isSeparator) mark = header[4];
        if (!isSeparator && !header.empty() && !header.starts_with('#')) break;
        text = rest;
    }
    std::string_view rest = text;
    const std::string_view header = takeLine(rest);
    if (mark == '\0')
        mark = header.find(';') != std::string_view::npos    ? ';'
               : header.find('\t') != std::string_view::npos ? '\t'
               : header.find('|') != std::string_view::npos  ? '|'
                                                             : ',';
    foundation::CsvRecord record = foundation::takeCsvRecord(text, mark);
    const TableColumns columns = columnsOf(record.cells);
    if (!columns.havePlace())
        return foundation::Error{name + ":" + std::to_string(line),
                                 "the first line names no columns for latitude and longitude",
                                 "begin with a line such as time,latitude,longitude,height"};
    TableReader reader(name, columns, record.cells);
    reader.builder().note(*read);
    while (!text.empty())
    {
        line += record.lines;
        record = foundation::takeCsvRecord(text, mark);
        if (record.cells.size() > 1 || !record.cells.front().empty()) reader.take(record.cells, line);
    }
    return reader.finish();
}

} // namespace simulation
