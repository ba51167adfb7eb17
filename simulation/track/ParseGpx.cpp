// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <string>

#include <foundation/XmlSource.h>

#include "simulation/parser/Expression.h"
#include "simulation/track/ReadTrack.h"
#include "simulation/track/TimeText.h"
#include "simulation/track/TrackBuilder.h"
#include "simulation/track/XmlNames.h"

namespace simulation
{
namespace
{

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
        _builder.beginPart();
        for (pugi::xml_node node : parent.children())
            if (plainName(node) == element) take(node);
    }

private:
    /// Whether most points have a time. Points of one and the same time, as some programs write them, have
    /// none.
    static bool timesDiffer(pugi::xml_node parent, std::string_view element)
    {
        std::optional<double> first;
        std::size_t points = 0, timed = 0;
        bool differ = false;
        for (pugi::xml_node node : parent.children())
        {
            if (plainName(node) != element) continue;
            ++points;
            const auto time = unixSeconds(textOf(node, "time"));
            if (!time) continue;
            ++timed;
            differ = differ || (first && *time != *first);
            first = first.value_or(*time);
        }
        return 2 * timed > points && (differ || points == 1);
    }

    /// A number; its decimal mark may be the comma of the writer's language, which the format forbids.
    static std::optional<double> coordinateOf(pugi::xml_node node, const char* name)
    {
        std::string text = node.attribute(name).value();
        if (std::count(text.begin(), text.end(), ',') == 1 && text.find('.') == std::string::npos)
            std::replace(text.begin(), text.end(), ',', '.');
        return parseNumber(text);
    }

    void take(pugi::xml_node node)
    {
        const int line = _source.lineOf(node);
        const auto latitude = coordinateOf(node, "lat"), longitude = coordinateOf(node, "lon");
        const std::string_view timeText = textOf(node, "time");
        const auto time = unixSeconds(timeText);
        if (!latitude || !longitude)
        {
            _builder.problem(line, "a point without lat and lon");
            return;
        }
        if (_track.hasTimes && !time)
        {
            _builder.problem(line, timeText.empty() ? "a point without time in a track that has them"
                                                    : "the time cannot be read");
            return;
        }
        const std::string_view height = textOf(node, "ele");
        const auto heightM = parseNumber(height);
        if (!height.empty() && !heightM) _builder.problem(line, "the height is no number");
        TrackFix fix{_track.hasTimes ? *time : 0.0, *latitude, *longitude, heightM, line};
        fix.geoidM = parseNumber(textOf(node, "geoidheight"));
        _builder.add(_track, fix);
    }

    TrackBuilder& _builder;
    const foundation::XmlSource& _source;
    FlightTrack& _track;
};

} // namespace

foundation::Result<TrackReading> parseGpx(std::string_view text, const std::string& name)
{
    const auto source = foundation::XmlSource::parse(text, name);
    if (!source) return source.error();
    TrackBuilder builder(name);
    tellNote(builder, **source);
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
    const pugi::xml_node root = (*source)->root(), mark = childOf(root, "wpt");
    if (mark && !childOf(root, "trk") && !childOf(root, "rte"))
        builder.problem((*source)->lineOf(mark), "it has waypoints, and no track or route");
    return builder.finish();
}

} // namespace simulation
