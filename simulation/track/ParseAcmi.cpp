// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "simulation/environment/DateTime.h"
#include "simulation/parser/Expression.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TrackBuilder.h"

namespace simulation
{
namespace
{

constexpr std::size_t kLongestLine = 1 << 20;

/// An object of the recording: the parts of its position that were told last.
struct AcmiObject
{
    std::string name, type;
    int place = 0; ///< in the order of the file
    std::vector<TrackFix> fixes;
    std::optional<double> longitudeDeg, latitudeDeg, heightM;
    std::optional<double> rollDeg, pitchDeg, yawDeg, headingDeg;
    std::optional<double> endS;

    /// Absent where no direction was told; what is left out of a direction is 0.
    std::optional<TrackAttitude> attitude() const
    {
        const std::optional<double> yaw = yawDeg ? yawDeg : headingDeg;
        if (!yaw) return std::nullopt;
        return TrackAttitude{*yaw, pitchDeg.value_or(0.0), rollDeg.value_or(0.0)};
    }
};

/// The kind by the tags of a type, such as Air+FixedWing.
TrackKind kindOf(const std::string& type)
{
    static constexpr std::pair<std::string_view, TrackKind> kTags[] = {
        {"Rotorcraft", TrackKind::helicopter}, {"Air", TrackKind::aircraft}, {"Human", TrackKind::person},
        {"Parachutist", TrackKind::person},    {"Navaid", TrackKind::mark},  {"Waypoint", TrackKind::mark},
        {"Watercraft", TrackKind::ship},       {"Sea", TrackKind::ship},     {"Vehicle", TrackKind::vehicle},
        {"Ground", TrackKind::vehicle}};
    for (const auto& [tag, kind] : kTags)
        for (std::size_t at = type.find(tag); at != std::string::npos; at = type.find(tag, at + 1))
            if ((at == 0 || type[at - 1] == '+') &&
                (at + tag.size() == type.size() || type[at + tag.size()] == '+'))
                return kind;
    return type.empty() ? TrackKind::unknown : TrackKind::thing;
}

/// Splits at a mark that no backslash stands before.
std::vector<std::string> split(std::string_view text, char mark)
{
    std::vector<std::string> parts(1);
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        if (text[i] == '\\' && i + 1 < text.size())
            parts.back() += text[++i];
        else if (text[i] == mark)
            parts.emplace_back();
        else
            parts.back() += text[i];
    }
    return parts;
}

class AcmiReader
{
public:
    explicit AcmiReader(const std::string& name) : _builder(name), _name(name) {}

    foundation::Result<TrackReading> run(const foundation::Utf8Text& read, std::string_view text)
    {
        _builder.note(read);
        text = read.in(text);
        if (trimmed(text).empty()) return foundation::Error{_name, "is empty", "record the flight again"};
        int line = 1;
        while (!text.empty())
        {
            const int first = line;
            std::string record(takeLine(text));
            ++line;
            while (record.ends_with('\\') && !text.empty() && record.size() < kLongestLine)
            {
                record.back() = '\n';
                record += takeLine(text);
                ++line;
            }
            take(record, first);
        }
        build();
        return _builder.finish();
    }

private:
    void build()
    {
        std::vector<std::pair<const std::string*, AcmiObject*>> objects;
        for (auto& [id, object] : _objects)
            objects.emplace_back(&id, &object);
        std::sort(objects.begin(), objects.end(),
                  [](const auto& a, const auto& b) { return a.second->place < b.second->place; });
        for (const auto& [id, object] : objects)
        {
            FlightTrack& track =
                _builder.begin(object->name.empty() ? *id : object->name, HeightDatum::meanSeaLevel);
            track.kind = kindOf(object->type);
            if (object->endS) track.endS = _startS + *object->endS;
            for (TrackFix& fix : object->fixes)
            {
                fix.timeS += _startS;
                _builder.add(track, fix);
            }
        }
    }

    AcmiObject& objectOf(const std::string& id)
    {
        const auto [entry, isNew] = _objects.try_emplace(id);
        if (isNew) entry->second.place = static_cast<int>(_objects.size());
        return entry->second;
    }

    void take(std::string_view record, int line)
    {
        if (record.empty() || record.starts_with("//") || record.starts_with("File")) return;
        if (record.front() == '#')
        {
            const auto time = parseNumber(record.substr(1));
            if (time)
                _timeS = *time;
            else
                _builder.problem(line, "a time that is no number");
            return;
        }
        if (record.front() == '-') // the object is gone; its track stays
        {
            const auto gone = _objects.find(record.substr(1));
            if (gone != _objects.end()) gone->second.endS = _timeS;
            return;
        }
        const std::vector<std::string> parts = split(record, ',');
        for (std::size_t i = 1; i < parts.size(); ++i)
        {
            const std::size_t equals = parts[i].find('=');
            if (equals == std::string::npos)
                _builder.problem(line, "a property without a value");
            else if (parts[0] == "0")
                setGlobal(parts[i].substr(0, equals), parts[i].substr(equals + 1), line);
            else
                setProperty(objectOf(parts[0]), parts[i].substr(0, equals), parts[i].substr(equals + 1),
                            line);
        }
    }

    void setGlobal(const std::string& name, const std::string& value, int line)
    {
        const auto number = parseNumber(value);
        if (name == "ReferenceTime")
        {
            const auto time = parseDateTime(value);
            if (time)
                _startS = static_cast<double>(time->unixMilliseconds) / 1000.0;
            else
                _builder.problem(line, "ReferenceTime is no date and time");
        }
        else if (name == "ReferenceLongitude" || name == "ReferenceLatitude")
        {
            if (!number)
                _builder.problem(line, name + " is no number");
            else
                (name == "ReferenceLongitude" ? _longitudeDeg : _latitudeDeg) = *number;
        }
    }

    void setProperty(AcmiObject& object, const std::string& name, const std::string& value, int line)
    {
        if (name == "Name") object.name = value;
        if (name == "Type") object.type = value;
        if (name != "T") return;
        const std::vector<std::string> parts = split(value, '|');
        if (!takePlace(object, parts))
        {
            _builder.problem(line, "a position that is no number");
            return;
        }
        if (!object.longitudeDeg || !object.latitudeDeg)
        {
            _builder.problem(line, "an object whose longitude and latitude nothing has told yet");
            return;
        }
        object.endS.reset();
        if (!object.fixes.empty() && object.fixes.back().timeS == _timeS) object.fixes.pop_back();
        object.fixes.push_back(
            {_timeS, *object.latitudeDeg, *object.longitudeDeg, object.heightM, line, object.attitude()});
    }

    /// Takes longitude, latitude, height; with 6 or 9 parts roll, pitch and yaw; with 5 or 9 two of a flat
    /// map, and with 9 the heading on it. An empty part stays as it was. Returns false where one is no
    /// number.
    bool takePlace(AcmiObject& object, const std::vector<std::string>& parts) const
    {
        std::optional<double>* const members[] = {
            &object.longitudeDeg, &object.latitudeDeg, &object.heightM, &object.rollDeg,
            &object.pitchDeg,     &object.yawDeg,      nullptr,         nullptr,
            &object.headingDeg};
        const double origins[] = {_longitudeDeg, _latitudeDeg};
        const std::size_t known = parts.size() == 5 ? 3 : std::min<std::size_t>(parts.size(), 9);
        for (std::size_t i = 0; i < known; ++i)
        {
            if (!members[i] || parts[i].empty()) continue;
            const auto number = parseNumber(parts[i]);
            if (!number || !(std::fabs(*number) <= 1e9)) return false;
            *members[i] = (i < 2 ? origins[i] : 0.0) + *number;
        }
        return true;
    }

    TrackBuilder _builder;
    std::string _name;
    std::map<std::string, AcmiObject, std::less<>> _objects; ///< by their ids
    double _timeS = 0.0, _startS = 0.0, _longitudeDeg = 0.0, _latitudeDeg = 0.0;
};

} // namespace

foundation::Result<TrackReading> parseAcmi(std::string_view text, const std::string& name)
{
    const auto read = foundation::Utf8Text::of(text, {}, name);
    if (!read) return read.error();
    return AcmiReader(name).run(*read, text);
}

} // namespace simulation
