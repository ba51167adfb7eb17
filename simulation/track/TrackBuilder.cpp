// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TrackBuilder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/track/FillHeights.h"
#include "simulation/track/TrackTimes.h"
#include "simulation/track/ZeroPlaces.h"

namespace simulation
{
namespace
{

constexpr std::size_t kMostProblems = 1000;
constexpr double kFarthestHeightM = 1e6;

} // namespace

const char* nameOf(HeightDatum datum)
{
    switch (datum)
    {
    case HeightDatum::ellipsoid:
        return "the ellipsoid";
    case HeightDatum::meanSeaLevel:
        return "mean sea level";
    case HeightDatum::pressure:
        return "the standard pressure";
    case HeightDatum::ground:
        return "the ground";
    }
    return "";
}

FlightTrack& TrackBuilder::begin(const std::string& name, HeightDatum datum)
{
    // A track without fixes is used again: no file makes more tracks than it has fixes.
    if (_reading.tracks.empty() || !_reading.tracks.back().fixes.empty()) _reading.tracks.emplace_back();
    _reading.tracks.back() = {name, {}, datum, true};
    return _reading.tracks.back();
}

void TrackBuilder::beginPart()
{
    if (!_reading.tracks.empty())
        _parts.emplace_back(_reading.tracks.size() - 1, _reading.tracks.back().fixes.size());
}

void TrackBuilder::add(FlightTrack& track, const TrackFix& fix)
{
    if (!(std::fabs(fix.latitudeDeg) <= 90.0 && std::fabs(fix.longitudeDeg) <= 180.0))
        problem(fix.line, "the position is not within 90 degrees of latitude and 180 of longitude");
    else if (fix.heightM && !(std::fabs(*fix.heightM) <= kFarthestHeightM))
        problem(fix.line, "the height is beyond 1000 km");
    else
        track.fixes.push_back(fix);
}

void TrackBuilder::problem(int line, const std::string& what)
{
    ++_reading.problemCount;
    if (_reading.problems.size() < kMostProblems) _reading.problems.push_back({line, what});
}

void TrackBuilder::note(int line, const std::string& what)
{
    if (_reading.notes.size() < kMostProblems) _reading.notes.push_back({line, what});
}

void TrackBuilder::note(const foundation::Utf8Text& text)
{
    if (text.strayBytes() > 0) note(text.strayLine(), text.strayWords());
}

foundation::Result<TrackReading> TrackBuilder::finish()
{
    for (std::size_t i = 0; i < _reading.tracks.size(); ++i)
    {
        FlightTrack& track = _reading.tracks[i];
        std::vector<int> lines;
        const std::vector<std::size_t> zeros = dropZeroPlaces(track, lines);
        for (const int line : lines)
            problem(line, "the position is 0 degrees north and east, far from the others");
        if (!track.hasTimes) continue;
        std::vector<std::size_t> parts;
        for (const auto& [of, first] : _parts)
            if (of == i)
                parts.push_back(first -
                                static_cast<std::size_t>(std::lower_bound(zeros.begin(), zeros.end(), first) -
                                                         zeros.begin()));
        const TimeOrder order = orderInTime(track.fixes, parts);
        for (const TrackProblem& fault : order.dropped)
            problem(fault.line, fault.what);
        if (order.isReversed && !track.fixes.empty())
            note(track.fixes.back().line, "the last fix stands first; the track is read backwards");
    }
    for (FlightTrack& track : _reading.tracks)
        if (const std::size_t given = fillHeights(track); given > 0)
            note(track.fixes.front().line, std::to_string(given) + " of " +
                                               std::to_string(track.fixes.size()) +
                                               " fixes have no height; it is taken from those beside them");
    const auto byLine = [](const TrackProblem& a, const TrackProblem& b) { return a.line < b.line; };
    std::stable_sort(_reading.problems.begin(), _reading.problems.end(), byLine);
    std::erase_if(_reading.tracks, [](const FlightTrack& track) { return track.fixes.empty(); });
    if (!_reading.tracks.empty()) return std::move(_reading);
    if (_reading.problems.empty())
        return foundation::Error{_name, "holds no position", "record the flight again, or name another file"};
    const TrackProblem& first = _reading.problems.front();
    return foundation::Error{_name + ":" + std::to_string(first.line),
                             "no position can be read: " + first.what, "correct the file"};
}

std::string_view takeLine(std::string_view& text)
{
    std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    // A return before another is one too many, and belongs to the same end of a line.
    const std::size_t next = std::min(text.find_first_not_of('\r', end), text.size());
    const std::string_view line = text.substr(0, end);
    if (next < text.size() && text[next] == '\n') end = next;
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

std::string_view trimmed(std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

} // namespace simulation
