// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <foundation/Angle.h>
#include <foundation/NearestWord.h>
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

/// Takes the tracks of a KML file: those with times, or where there is none its lines.
/// Source: Open Geospatial Consortium, *KML 2.3*, 9.6 (Track, MultiTrack), 15.1 (TimeStamp).
class KmlReader
{
public:
    KmlReader(const foundation::XmlSource& source, const std::string& name) : _source(source), _builder(name)
    {
        tellNote(_builder, source);
    }

    foundation::Result<TrackReading> run()
    {
        takeTracks(_source.root(), nullptr, {});
        if (!_hasFixes) takePoints(_source.root());
        if (!_hasFixes) takeUntimed();
        for (const Untimed& way : _untimed) // beside others that have times
            lacksWhen(way.places.front());
        if (!_hasFixes) takeLines(_source.root(), {}, "");
        return _builder.finish();
    }

private:
    static HeightDatum datumOf(std::string_view mode)
    {
        return mode == "absolute" ? HeightDatum::meanSeaLevel : HeightDatum::ground;
    }

    /// What holds for the tracks below an element.
    struct Above
    {
        std::string_view name, mode;
    };

    /// The mode of an element, or of the one around it. Above the floor of the sea is above the ground: the
    /// terrain has no water in it.
    std::string_view modeOf(pugi::xml_node node, std::string_view outer)
    {
        std::string_view mode = knownMode(childOf(node, "altitudeMode"));
        if (mode.empty()) mode = outer;
        if (mode == "relativeToSeaFloor")
            _builder.note(_source.lineOf(node),
                          "heights above the floor of the sea are taken as above the ground");
        return mode;
    }

    /// The mode that an element names, or the one that is like it; empty: none.
    std::string_view knownMode(pugi::xml_node node)
    {
        constexpr std::array<std::string_view, 5> kModes{"absolute", "relativeToGround", "clampToGround",
                                                         "relativeToSeaFloor", "clampToSeaFloor"};
        const std::string_view mode = trimmed(node.text().get());
        if (mode.empty() || std::find(kModes.begin(), kModes.end(), mode) != kModes.end()) return mode;
        const auto like =
            foundation::nearestWord(mode, kModes, [](const auto& word) { return std::string_view(word); });
        const std::string_view taken = like ? std::string_view(*like) : "clampToGround";
        _builder.note(_source.lineOf(node), "there is no altitudeMode '" + std::string(mode.substr(0, 40)) +
                                                "'; it is taken as " + std::string(taken));
        return taken;
    }

    /// What holds for the tracks of a Placemark. A mode has its place in the geometry, where Google Earth
    /// alone looks for it.
    Above ofPlacemark(pugi::xml_node node)
    {
        const pugi::xml_node mode = childOf(node, "altitudeMode");
        if (mode)
            _builder.note(_source.lineOf(mode),
                          "an altitudeMode beside the geometry counts for what has none of its own");
        return {textOf(node, "name"), knownMode(mode)};
    }

    /// Finds each Track; those of one MultiTrack are one object's. At most 64 deep.
    void takeTracks(pugi::xml_node node, FlightTrack* joined, Above above)
    {
        if (plainName(node) == "Placemark") above = ofPlacemark(node);
        for (pugi::xml_node child : node.children())
        {
            if (plainName(child) == "MultiTrack" && !joined)
            {
                FlightTrack& track = _builder.begin(std::string(above.name), HeightDatum::ground);
                const std::string_view mode = knownMode(childOf(child, "altitudeMode"));
                takeTracks(child, &track, {above.name, mode.empty() ? above.mode : mode});
            }
            else if (plainName(child) == "Track")
                takeTrack(child, joined, above);
            else
                takeTracks(child, joined, above);
        }
    }

    /// As many `when` as `coord`: all of the one before all of the other, or by turns, where each is the
    /// neighbour's; what lacks its partner is told.
    void takeTrack(pugi::xml_node node, FlightTrack* joined, const Above& above)
    {
        const std::string_view mode = modeOf(node, above.mode);
        FlightTrack& track = joined ? *joined : _builder.begin(std::string(above.name), datumOf(mode));
        if (track.fixes.empty()) track.datum = datumOf(mode);
        _builder.beginPart();
        std::vector<pugi::xml_node> times, places;
        pugi::xml_node first;
        bool isByTurns = false;
        for (pugi::xml_node child : node.children())
        {
            const bool isTime = isWhen(child);
            if (!isTime && plainName(child) != "coord") continue;
            (isTime ? times : places).push_back(child);
            first = first ? first : child;
            isByTurns = isByTurns || (isTime == isWhen(first) && !(isTime ? places : times).empty());
        }
        if (times.empty() && !places.empty()) return _untimed.push_back({places, above.name, mode});
        if (isByTurns) return takeByTurns(track, first, mode);
        for (std::size_t i = 0; i < std::min(times.size(), places.size()); ++i)
            take(track, times[i], places[i], places[i].text().get(), mode);
        for (std::size_t i = times.size(); i < places.size(); ++i)
            lacksWhen(places[i]);
        for (std::size_t i = places.size(); i < times.size(); ++i)
            lacksCoord(times[i]);
    }

    /// Tracks without a single `when` are ways without times, where nothing in the file has times.
    void takeUntimed()
    {
        for (const Untimed& way : _untimed)
        {
            FlightTrack& track = _builder.begin(std::string(way.name), datumOf(way.mode));
            track.hasTimes = false;
            for (const pugi::xml_node place : way.places)
                take(track, {}, place, place.text().get(), way.mode);
        }
        _untimed.clear();
    }

    /// `leader`: the first of them; its kind comes first in each pair.
    void takeByTurns(FlightTrack& track, pugi::xml_node leader, std::string_view mode)
    {
        pugi::xml_node waiting; // for its partner
        const auto tell = [&](pugi::xml_node alone) { isWhen(alone) ? lacksCoord(alone) : lacksWhen(alone); };
        for (pugi::xml_node child = leader; child; child = child.next_sibling())
        {
            if (!isWhen(child) && plainName(child) != "coord") continue;
            const bool leads = isWhen(child) == isWhen(leader);
            if (!leads && waiting)
            {
                const pugi::xml_node place = isWhen(child) ? waiting : child;
                take(track, isWhen(child) ? child : waiting, place, place.text().get(), mode);
            }
            else if (!leads || waiting)
                tell(leads ? waiting : child);
            waiting = leads ? child : pugi::xml_node();
        }
        if (waiting) tell(waiting);
    }

    static bool isWhen(pugi::xml_node node) { return plainName(node) == "when"; }
    void lacksWhen(pugi::xml_node place)
    {
        _builder.problem(_source.lineOf(place), "a gx:coord without a when");
    }
    void lacksCoord(pugi::xml_node when)
    {
        _builder.problem(_source.lineOf(when), "a when without a gx:coord");
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
            const std::string_view mode = modeOf(points.begin()->second.second, {});
            FlightTrack& track = _builder.begin(std::string(textOf(node, "name")), datumOf(mode));
            for (const auto& [time, mark] : points)
                take(track, mark.first, mark.second, textOf(mark.second, "coordinates"), mode);
        }
        for (pugi::xml_node child : node.children())
            takePoints(child);
    }

    /// Finds lines: ways without times, or with those of the TimeSpan of their `mark`.
    void takeLines(pugi::xml_node node, pugi::xml_node mark, std::string_view name)
    {
        if (plainName(node) == "Placemark") mark = node, name = textOf(node, "name");
        for (pugi::xml_node child : node.children())
        {
            if (plainName(child) != "LineString")
            {
                takeLines(child, mark, name);
                continue;
            }
            const std::string_view mode = modeOf(child, {});
            FlightTrack& track = _builder.begin(std::string(name), datumOf(mode));
            track.hasTimes = false;
            std::string_view text = textOf(child, "coordinates");
            while (!text.empty())
            {
                const std::size_t end = endOfPlace(text);
                take(track, {}, child, text.substr(0, end), mode);
                text = trimmed(text.substr(end));
            }
            if (childOf(mark, "LineString") == child) spreadTimes(track, childOf(mark, "TimeSpan"));
        }
    }

    /// Gives the fixes of a line the times of a span, by the way that lies behind them.
    void spreadTimes(FlightTrack& track, pugi::xml_node span)
    {
        const auto begin = unixSeconds(textOf(span, "begin")), end = unixSeconds(textOf(span, "end"));
        if (!begin || !end || !(*end > *begin)) return;
        const auto isSame = [](const TrackFix& a, const TrackFix& b)
        { return a.latitudeDeg == b.latitudeDeg && a.longitudeDeg == b.longitudeDeg; };
        track.fixes.erase(std::unique(track.fixes.begin(), track.fixes.end(), isSame), track.fixes.end());
        if (track.fixes.size() < 2) return;
        std::vector<double> behindDeg{0.0};
        for (std::size_t i = 1; i < track.fixes.size(); ++i)
        {
            const TrackFix &from = track.fixes[i - 1], &to = track.fixes[i];
            const double narrow = std::cos(foundation::radiansOf(from.latitudeDeg));
            const double eastDeg = foundation::wrappedDeg(to.longitudeDeg - from.longitudeDeg) * narrow;
            behindDeg.push_back(behindDeg.back() + std::hypot(eastDeg, to.latitudeDeg - from.latitudeDeg));
        }
        for (std::size_t i = 0; i < track.fixes.size(); ++i)
            track.fixes[i].timeS = *begin + (*end - *begin) * behindDeg[i] / behindDeg.back();
        track.hasTimes = true;
        _builder.note(_source.lineOf(span), "a line has the times of its TimeSpan at an even speed");
    }

    /// Where the first of several places ends: at a blank that no comma stands beside.
    static std::size_t endOfPlace(std::string_view text)
    {
        constexpr const char* kBlanks = " \t\r\n";
        std::size_t end = text.find_first_of(kBlanks);
        while (end != std::string_view::npos)
        {
            const std::size_t next = text.find_first_not_of(kBlanks, end);
            if (next == std::string_view::npos || (text[next] != ',' && text[end - 1] != ',')) return end;
            end = text.find_first_of(kBlanks, next);
        }
        return text.size();
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
            text = trimmed(text.substr(end));
            if (text.starts_with(',')) text = trimmed(text.substr(1));
        }
        const auto time = when ? unixSeconds(when.text().get()) : std::optional(0.0);
        if (!time) return _builder.problem(_source.lineOf(when), "the time cannot be read");
        if (text.empty() && numbers.empty()) return _builder.problem(line, "a fix without a position");
        if (numbers.size() < 2 || !numbers[0] || !numbers[1] || (numbers.size() > 2 && !numbers[2]))
            return _builder.problem(line, "a place is not longitude, latitude and height");
        const bool isClamped = mode.empty() || mode == "clampToGround" || mode == "clampToSeaFloor";
        const std::optional<double> height = isClamped ? 0.0 : numbers.size() > 2 ? numbers[2] : std::nullopt;
        TrackFix fix{*time, *numbers[1], *numbers[0], height, line};
        fix.datum = datumOf(mode); // tracks of one MultiTrack may differ
        _builder.add(track, fix);
        _hasFixes = _hasFixes || !track.fixes.empty();
    }

    /// A Track without a `when`.
    struct Untimed
    {
        std::vector<pugi::xml_node> places;
        std::string_view name, mode;
    };

    const foundation::XmlSource& _source;
    TrackBuilder _builder;
    std::vector<Untimed> _untimed;
    bool _hasFixes = false;
};

} // namespace

foundation::Result<TrackReading> parseKml(std::string_view text, const std::string& name)
{
    const auto source = foundation::XmlSource::parse(text, name);
    if (!source) return source.error();
    return KmlReader(**source, name).run();
}

} // namespace simulation
