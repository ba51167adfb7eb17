// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <vector>

#include <foundation/XmlSource.h>

#include "simulation/parser/Expression.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TrackBuilder.h"
#include "simulation/track/XmlNames.h"

namespace simulation
{
namespace
{

/// Takes the tracks of a KML file: those with times, or where there is none its lines.
/// Source: Open Geospatial Consortium, *KML 2.3*, 9.6 (Track, MultiTrack), 15.1 (TimeStamp).
class KmlReader
{
public:
    KmlReader(const foundation::XmlSource& source, const std::string& name) : _source(source), _builder(name)
    {
    }

    foundation::Result<TrackReading> run()
    {
        takeTracks(_source.root(), nullptr, "");
        if (!_hasFixes) takePoints(_source.root());
        if (!_hasFixes) takeLines(_source.root(), "");
        return _builder.finish();
    }

private:
    static HeightDatum datumOf(std::string_view mode)
    {
        return mode == "absolute" ? HeightDatum::meanSeaLevel : HeightDatum::ground;
    }

    /// Finds each Track; those of one MultiTrack are one object's. At most 64 deep.
    void takeTracks(pugi::xml_node node, FlightTrack* joined, std::string_view name)
    {
        if (plainName(node) == "Placemark") name = textOf(node, "name");
        for (pugi::xml_node child : node.children())
        {
            if (plainName(child) == "MultiTrack" && !joined)
            {
                FlightTrack& track = _builder.begin(std::string(name), HeightDatum::ground);
                takeTracks(child, &track, name);
            }
            else if (plainName(child) == "Track")
                takeTrack(child, joined, name);
            else
                takeTracks(child, joined, name);
        }
    }

    /// As many `when` as `coord`.
    void takeTrack(pugi::xml_node node, FlightTrack* joined, std::string_view name)
    {
        const std::string_view mode = textOf(node, "altitudeMode");
        FlightTrack& track = joined ? *joined : _builder.begin(std::string(name), datumOf(mode));
        if (track.fixes.empty()) track.datum = datumOf(mode);
        std::vector<pugi::xml_node> times, places;
        for (pugi::xml_node child : node.children())
        {
            if (plainName(child) == "when") times.push_back(child);
            if (plainName(child) == "coord") places.push_back(child);
        }
        for (std::size_t i = 0; i < std::min(times.size(), places.size()); ++i)
            take(track, times[i], places[i], places[i].text().get(), mode);
        if (places.size() > times.size())
            _builder.problem(_source.lineOf(places[times.size()]), "a gx:coord without a when");
        if (times.size() > places.size())
            _builder.problem(_source.lineOf(times[places.size()]), "a when without a gx:coord");
    }

    /// Finds points that have a time each: those side by side are one object's.
    void takePoints(pugi::xml_node node)
    {
        std::map<double, std::pair<pugi::xml_node, pugi::xml_node>> points; // by time
        for (pugi::xml_node mark : node.children())
        {
            const pugi::xml_node when = childOf(childOf(mark, "TimeStamp"), "when");
            const pugi::xml_node point = childOf(mark, "Point");
            if (const auto time = when && point ? unixSeconds(when.text().get()) : std::nullopt)
                points.emplace(*time, std::pair(when, point));
        }
        if (points.size() > 1)
        {
            const std::string_view mode = textOf(points.begin()->second.second, "altitudeMode");
            FlightTrack& track = _builder.begin(std::string(textOf(node, "name")), datumOf(mode));
            for (const auto& [time, mark] : points)
                take(track, mark.first, mark.second, textOf(mark.second, "coordinates"), mode);
        }
        for (pugi::xml_node child : node.children())
            takePoints(child);
    }

    /// Finds lines: ways without times.
    void takeLines(pugi::xml_node node, std::string_view name)
    {
        if (plainName(node) == "Placemark") name = textOf(node, "name");
        for (pugi::xml_node child : node.children())
        {
            if (plainName(child) != "LineString")
            {
                takeLines(child, name);
                continue;
            }
            const std::string_view mode = textOf(child, "altitudeMode");
            FlightTrack& track = _builder.begin(std::string(name), datumOf(mode));
            track.hasTimes = false;
            std::string_view text = textOf(child, "coordinates");
            while (!text.empty())
            {
                const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
                take(track, {}, child, text.substr(0, end), mode);
                text = trimmed(text.substr(end));
            }
        }
    }

    /// Longitude, latitude and height, parted by blanks or commas.
    void take(FlightTrack& track, pugi::xml_node when, pugi::xml_node place, std::string_view text,
              std::string_view mode)
    {
        const int line = _source.lineOf(place);
        std::vector<std::optional<double>> numbers;
        text = trimmed(text);
        while (!text.empty() && numbers.size() < 4)
        {
            const std::size_t end = std::min(text.find_first_of(", \t\r\n"), text.size());
            numbers.push_back(parseNumber(text.substr(0, end)));
            text = trimmed(text.substr(std::min(end + 1, text.size())));
        }
        const auto time = when ? unixSeconds(when.text().get()) : std::optional(0.0);
        if (!time) return _builder.problem(_source.lineOf(when), "the time cannot be read");
        if (numbers.size() < 2 || !numbers[0] || !numbers[1] || (numbers.size() > 2 && !numbers[2]))
            return _builder.problem(line, "a gx:coord is not longitude, latitude and height");
        const bool isClamped = mode.empty() || mode == "clampToGround";
        const std::optional<double> height = isClamped ? 0.0 : numbers.size() > 2 ? numbers[2] : std::nullopt;
        _builder.add(track, {*time, *numbers[1], *numbers[0], height, line});
        _hasFixes = _hasFixes || !track.fixes.empty();
    }

    const foundation::XmlSource& _source;
    TrackBuilder _builder;
    bool _hasFixes = false;
};

} // namespace

foundation::Result<TrackReading> parseKml(std::string_view text, const std::string& name)
{
    const auto source = foundation::XmlSource::parse(withoutMark(text), name);
    if (!source) return source.error();
    return KmlReader(**source, name).run();
}

} // namespace simulation
