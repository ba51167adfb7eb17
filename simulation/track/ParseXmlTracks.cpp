// SPDX-License-Identifier: Apache-2.0
// GPX and KML.
#include <foundation/XmlSource.h>

#include "simulation/environment/DateTime.h"
#include "simulation/parser/Expression.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TrackBuilder.h"

namespace simulation
{
namespace
{

/// The name of an element without the prefix of its namespace.
std::string_view plainName(pugi::xml_node node)
{
    const std::string_view name = node.name();
    const std::size_t colon = name.rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string_view textOf(pugi::xml_node parent, std::string_view name)
{
    for (pugi::xml_node child : parent.children())
        if (plainName(child) == name) return trimmed(child.text().get());
    return {};
}

std::optional<double> unixSeconds(std::string_view text)
{
    const auto time = parseDateTime(trimmed(text));
    if (!time) return std::nullopt;
    return static_cast<double>(time->unixMilliseconds) / 1000.0;
}

/// Reads the points of one track or route of a GPX file.
class GpxPoints
{
public:
    GpxPoints(TrackBuilder& builder, const foundation::XmlSource& source, FlightTrack& track)
        : _builder(builder), _source(source), _track(track)
    {
    }

    void take(pugi::xml_node parent, std::string_view element)
    {
        if (_track.fixes.empty()) _track.hasTimes = timesDiffer(parent, element);
        for (pugi::xml_node node : parent.children())
            if (plainName(node) == element) take(node);
    }

private:
    /// Points of one and the same time, as some programs write them, have none.
    static bool timesDiffer(pugi::xml_node parent, std::string_view element)
    {
        std::optional<double> first;
        std::size_t points = 0;
        for (pugi::xml_node node : parent.children())
        {
            if (plainName(node) != element) continue;
            ++points;
            const auto time = unixSeconds(textOf(node, "time"));
            if (points == 1 && !time) return false;
            if (points == 1) first = time;
            if (time && *time != *first) return true;
        }
        return points == 1 && first;
    }

    void take(pugi::xml_node node)
    {
        const int line = _source.lineOf(node);
        const auto latitude = parseNumber(node.attribute("lat").value());
        const auto longitude = parseNumber(node.attribute("lon").value());
        const auto time = unixSeconds(textOf(node, "time"));
        if (!latitude || !longitude)
        {
            _builder.problem(line, "a point without lat and lon");
            return;
        }
        if (_track.hasTimes && !time)
        {
            _builder.problem(line, "a point without time in a track that has them");
            return;
        }
        const std::string_view height = textOf(node, "ele");
        const auto heightM = parseNumber(height);
        if (!height.empty() && !heightM) _builder.problem(line, "the height is no number");
        _builder.add(_track, {_track.hasTimes ? *time : 0.0, *latitude, *longitude, heightM, line});
    }

    TrackBuilder& _builder;
    const foundation::XmlSource& _source;
    FlightTrack& _track;
};

/// Reads a gx:Track: as many `when` as `gx:coord`.
void takeKmlTrack(pugi::xml_node node, const foundation::XmlSource& source, TrackBuilder& builder)
{
    const std::string_view mode = textOf(node, "altitudeMode");
    FlightTrack& track = builder.begin(std::string(textOf(node.parent(), "name")),
                                       mode == "absolute" ? HeightDatum::meanSeaLevel : HeightDatum::ground);
    std::vector<std::pair<int, std::optional<double>>> times;
    for (pugi::xml_node child : node.children())
        if (plainName(child) == "when")
            times.emplace_back(source.lineOf(child), unixSeconds(child.text().get()));
    std::size_t index = 0;
    for (pugi::xml_node child : node.children())
    {
        if (plainName(child) != "coord") continue;
        const int line = source.lineOf(child);
        std::string_view text = trimmed(child.text().get());
        std::vector<std::optional<double>> numbers;
        while (!text.empty() && numbers.size() < 4)
        {
            const std::size_t end = std::min(text.find_first_of(" \t\n"), text.size());
            numbers.push_back(parseNumber(text.substr(0, end)));
            text = trimmed(text.substr(end));
        }
        const std::size_t at = index++;
        if (at >= times.size())
            builder.problem(line, "a gx:coord without a when");
        else if (!times[at].second)
            builder.problem(times[at].first, "the time cannot be read");
        else if (numbers.size() < 2 || !numbers[0] || !numbers[1] || (numbers.size() > 2 && !numbers[2]))
            builder.problem(line, "a gx:coord is not longitude, latitude and height");
        else
        {
            const bool isClamped = mode.empty() || mode == "clampToGround";
            const std::optional<double> height = isClamped            ? 0.0
                                                 : numbers.size() > 2 ? numbers[2]
                                                                      : std::nullopt;
            builder.add(track, {*times[at].second, *numbers[1], *numbers[0], height, line});
        }
    }
    if (index < times.size()) builder.problem(times[index].first, "a when without a gx:coord");
}

void findKmlTracks(pugi::xml_node node, const foundation::XmlSource& source, TrackBuilder& builder)
{
    for (pugi::xml_node child : node.children())
        if (std::string_view(child.name()).ends_with(":Track"))
            takeKmlTrack(child, source, builder);
        else
            findKmlTracks(child, source, builder); // at most 64 deep
}

std::string_view withoutMark(std::string_view text)
{
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

} // namespace

foundation::Result<TrackReading> parseGpx(std::string_view text, const std::string& name)
{
    const auto source = foundation::XmlSource::parse(withoutMark(text), name);
    if (!source) return source.error();
    TrackBuilder builder(name);
    for (pugi::xml_node node : (*source)->root().children())
    {
        const bool isTrack = plainName(node) == "trk";
        if (!isTrack && plainName(node) != "rte") continue;
        FlightTrack& track = builder.begin(std::string(textOf(node, "name")), HeightDatum::meanSeaLevel);
        GpxPoints points(builder, **source, track);
        if (!isTrack) points.take(node, "rtept");
        for (pugi::xml_node segment : node.children())
            if (isTrack && plainName(segment) == "trkseg") points.take(segment, "trkpt");
    }
    return builder.finish();
}

foundation::Result<TrackReading> parseKml(std::string_view text, const std::string& name)
{
    const auto source = foundation::XmlSource::parse(withoutMark(text), name);
    if (!source) return source.error();
    TrackBuilder builder(name);
    findKmlTracks((*source)->root(), **source, builder);
    return builder.finish();
}

} // namespace simulation
