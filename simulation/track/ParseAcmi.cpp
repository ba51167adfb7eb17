// SPDX-License-Identifier: Apache-2.0
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
    std::string name;
    std::vector<TrackFix> fixes;
    std::optional<double> longitudeDeg, latitudeDeg, heightM;
};

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

    foundation::Result<TrackReading> run(std::string_view text)
    {
        if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
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
        for (auto& [id, object] : _objects)
        {
            FlightTrack& track =
                _builder.begin(object.name.empty() ? id : object.name, HeightDatum::meanSeaLevel);
            for (TrackFix& fix : object.fixes)
            {
                fix.timeS += _startS;
                _builder.add(track, fix);
            }
        }
        return _builder.finish();
    }

private:
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
        if (record.front() == '-') return; // the object is gone; its track stays
        const std::vector<std::string> parts = split(record, ',');
        for (std::size_t i = 1; i < parts.size(); ++i)
        {
            const std::size_t equals = parts[i].find('=');
            if (equals == std::string::npos)
                _builder.problem(line, "a property without a value");
            else if (parts[0] == "0")
                setGlobal(parts[i].substr(0, equals), parts[i].substr(equals + 1), line);
            else
                setProperty(_objects[parts[0]], parts[i].substr(0, equals), parts[i].substr(equals + 1),
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
        if (name != "T") return;
        const std::vector<std::string> parts = split(value, '|');
        std::optional<double>* const members[] = {&object.longitudeDeg, &object.latitudeDeg, &object.heightM};
        const double origins[] = {_longitudeDeg, _latitudeDeg, 0.0};
        for (std::size_t i = 0; i < 3 && i < parts.size(); ++i)
        {
            if (parts[i].empty()) continue; // as it was
            const auto number = parseNumber(parts[i]);
            if (!number)
            {
                _builder.problem(line, "a position that is no number");
                return;
            }
            *members[i] = origins[i] + *number;
        }
        if (!object.longitudeDeg || !object.latitudeDeg)
        {
            _builder.problem(line, "an object whose longitude and latitude nothing has told yet");
            return;
        }
        if (!object.fixes.empty() && object.fixes.back().timeS == _timeS) object.fixes.pop_back();
        object.fixes.push_back({_timeS, *object.latitudeDeg, *object.longitudeDeg, object.heightM, line});
    }

    TrackBuilder _builder;
    std::string _name;
    std::map<std::string, AcmiObject> _objects; ///< by their ids
    double _timeS = 0.0, _startS = 0.0, _longitudeDeg = 0.0, _latitudeDeg = 0.0;
};

} // namespace

foundation::Result<TrackReading> parseAcmi(std::string_view text, const std::string& name)
{
    return AcmiReader(name).run(text);
}

} // namespace simulation
