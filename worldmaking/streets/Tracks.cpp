// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/Tracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "worldmaking/streets/Overpass.h"

namespace worldmaking
{

namespace
{

constexpr double kTrackStepM = 6.0; ///< between heights along a railway
constexpr double kFlushM = 0.02;    ///< of rails above the street at a level crossing
constexpr double kEaseM = 36.0;     ///< over which rails come down to a level crossing
constexpr double kOffGroundM = 0.2; ///< more needs earth to be moved

struct TrackClass
{
    std::string_view kind;
    double steepest;
};

constexpr std::array<TrackClass, 4> kTrackClasses{
    {{"rail", 0.04}, {"preserved", 0.04}, {"light_rail", 0.06}, {"narrow_gauge", 0.07}}};
constexpr double kMainLine = 0.025;

using NodeKey = std::pair<std::int64_t, std::int64_t>;

NodeKey keyOf(double latitudeDeg, double longitudeDeg)
{
    constexpr double kPerDegree = 1e7;
    return {std::llround(latitudeDeg * kPerDegree), std::llround(longitudeDeg * kPerDegree)};
}

/// Cuts one chain of railways into stretches.
class TrackCutter
{
public:
    TrackCutter(const StreetGraph& graph, const std::vector<CentreLine>& lines,
                const std::vector<glm::dvec2>& places, const StreetHeights& heights,
                const std::vector<TrackSpan>& spans, const GroundHeight& ground)
        : _graph(graph), _lines(lines), _places(places), _heights(heights), _spans(spans), _ground(ground)
    {
    }

    void cut(std::size_t index)
    {
        const StreetChain& chain = _graph.chains[index];
        const auto& pointsM = _lines[index].pointsM();
        for (std::size_t piece = 0; piece < chain.pieces.size(); ++piece)
        {
            const glm::dvec2 from = _places[chain.points[piece]], to = _places[chain.points[piece + 1]];
            const double lengthM = glm::distance(from, to);
            const int steps = std::max(1, static_cast<int>(std::ceil(lengthM / kTrackStepM)));
            for (int step = 0; step < steps; ++step)
            {
                const double share = (step + 0.5) / steps;
                begin(index, piece, std::lerp(pointsM[piece], pointsM[piece + 1], share));
                for (const int end : {step, step + 1})
                    add(index, glm::mix(from, to, static_cast<double>(end) / steps),
                        std::lerp(pointsM[piece], pointsM[piece + 1], static_cast<double>(end) / steps));
            }
        }
        _isOpen = false;
    }

    std::vector<Track> tracks;

private:
    /// Goes on with the last stretch, or begins one.
    void begin(std::size_t index, std::size_t piece, double alongM)
    {
        const StreetChain& chain = _graph.chains[index];
        const auto shape = static_cast<std::size_t>(chain.pieces[piece].way);
        StreetPlace place = _graph.traitsAt(chain, piece).place;
        for (const TrackSpan& span : _spans)
            if (span.chain == index && alongM >= span.fromM && alongM <= span.toM)
                place = StreetPlace::bridge;
        if (_isOpen && tracks.back().shape == shape && tracks.back().place == place) return;
        tracks.push_back({shape, {}, {}, place});
        _isOpen = true;
    }

    void add(std::size_t index, const glm::dvec2& place, double alongM)
    {
        Track& track = tracks.back();
        if (!track.points.empty() && glm::distance(track.points.back(), place) < 1e-6) return;
        double heightM = _heights.profiles[index].elevation.value(alongM);
        for (const LevelHeight& level : _heights.levels)
        {
            if (level.track != index) continue;
            const double away = std::fabs(alongM - level.trackM) / kEaseM;
            if (away >= 1.0) continue;
            const double flushM = level.streetM + kFlushM - kRailTopM;
            const double wasM = _heights.profiles[index].elevation.value(level.trackM);
            heightM += (flushM - wasM) * (1.0 - glm::smoothstep(0.0, 1.0, away));
        }
        const auto groundM = _ground(place);
        track.isOffGround = track.isOffGround || (groundM && std::fabs(*groundM - heightM) > kOffGroundM);
        track.points.push_back(place);
        track.heightsM.push_back(heightM);
    }

    const StreetGraph& _graph;
    const std::vector<CentreLine>& _lines;
    const std::vector<glm::dvec2>& _places;
    const StreetHeights& _heights;
    const std::vector<TrackSpan>& _spans;
    const GroundHeight& _ground;
    bool _isOpen = false;
};

} // namespace

std::optional<StreetTraits> trackTraitsOf(const Tags& tags)
{
    const auto found =
        std::find_if(kTrackClasses.begin(), kTrackClasses.end(),
                     [&](const TrackClass& entry) { return entry.kind == valueOf(tags, "railway"); });
    if (found == kTrackClasses.end()) return std::nullopt;
    StreetTraits traits;
    traits.name = valueOf(tags, "name");
    traits.kind = found->kind;
    traits.backwardLanes = 0;
    traits.laneWidthM = 3.4;
    traits.steepest = valueOf(tags, "usage") == "main" ? kMainLine : found->steepest;
    const WayLevel level = levelOf(tags);
    traits.place = level.place;
    traits.layer = level.layer;
    traits.isTrack = true;
    traits.hasWire = valueOf(tags, "electrified") == "contact_line";
    return traits;
}

StreetMap tracksOf(const LandMap& land, const std::vector<MapNode>& nodes, const GroundOnEarth& ground)
{
    StreetMap map;
    map.nodes = nodes;
    std::map<NodeKey, std::uint32_t> numbers;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        numbers.try_emplace(keyOf(nodes[i].latitudeDeg, nodes[i].longitudeDeg),
                            static_cast<std::uint32_t>(i));
    for (std::size_t i = 0; i < land.shapes.size(); ++i)
    {
        const LandShape& shape = land.shapes[i];
        if (shape.form != ShapeForm::line || !trackTraitsOf(shape.tags)) continue;
        const auto& path = shape.paths.front();
        if (!std::all_of(path.begin(), path.end(),
                         [&](const glm::dvec2& place) { return ground(place.y, place.x).has_value(); }))
            continue;
        MapWay way{static_cast<std::int64_t>(i), {}, shape.tags};
        for (const glm::dvec2& place : path)
        {
            const auto [found, isNew] =
                numbers.try_emplace(keyOf(place.y, place.x), static_cast<std::uint32_t>(map.nodes.size()));
            if (isNew) map.nodes.push_back({0, place.y, place.x});
            if (way.nodes.empty() || way.nodes.back() != found->second) way.nodes.push_back(found->second);
        }
        if (way.nodes.size() > 1) map.ways.push_back(std::move(way));
    }
    return map;
}

void openShortTunnels(StreetGraph& tracks, const std::vector<glm::dvec2>& places, const GroundHeight& ground)
{
    constexpr double kLongM = 60.0, kHillM = 4.0;
    for (const StreetChain& chain : tracks.chains)
        for (std::size_t first = 0; first < chain.pieces.size(); ++first)
        {
            if (tracks.traitsAt(chain, first).place != StreetPlace::tunnel) continue;
            std::size_t last = first;
            double lengthM = 0.0;
            for (; last < chain.pieces.size() && tracks.traitsAt(chain, last).place == StreetPlace::tunnel;
                 ++last)
                lengthM += glm::distance(places[chain.points[last]], places[chain.points[last + 1]]);
            const glm::dvec2 from = places[chain.points[first]], to = places[chain.points[last]];
            const auto a = ground(from), b = ground(to), middle = ground(0.5 * (from + to));
            const bool isHill = !a || !b || !middle || *middle - 0.5 * (*a + *b) > kHillM;
            if (lengthM <= kLongM && !isHill)
                for (std::size_t k = first; k < last; ++k)
                    tracks.traits[chain.pieces[k].traits].place = StreetPlace::ground;
            first = last;
        }
}

StreetGraph joined(const StreetGraph& streets, const StreetGraph& tracks)
{
    StreetGraph all = streets;
    all.traits.insert(all.traits.end(), tracks.traits.begin(), tracks.traits.end());
    const int crossings = static_cast<int>(streets.crossings.size());
    for (StreetChain chain : tracks.chains)
    {
        for (StreetChain::Piece& piece : chain.pieces)
            piece.traits += streets.traits.size();
        if (chain.startCrossing >= 0) chain.startCrossing += crossings;
        if (chain.endCrossing >= 0) chain.endCrossing += crossings;
        all.chains.push_back(std::move(chain));
    }
    for (Crossing crossing : tracks.crossings)
    {
        for (StreetArm& arm : crossing.arms)
            arm.chain += streets.chains.size();
        all.crossings.push_back(std::move(crossing));
    }
    return all;
}

std::vector<LevelPlace> levelPlaces(const StreetGraph& graph, std::size_t tracks,
                                    const std::vector<CentreLine>& lines)
{
    std::map<std::uint32_t, std::pair<std::size_t, double>> streets; // the last chain at each node
    for (std::size_t i = 0; i < tracks; ++i)
        for (std::size_t k = 0; k < graph.chains[i].points.size(); ++k)
            streets[graph.chains[i].points[k]] = {i, lines[i].pointsM()[k]};
    std::vector<LevelPlace> found;
    for (std::size_t i = tracks; i < graph.chains.size(); ++i)
        for (std::size_t k = 0; k < graph.chains[i].points.size(); ++k)
            if (const auto at = streets.find(graph.chains[i].points[k]); at != streets.end())
                found.push_back({at->second.first, i, at->second.second, lines[i].pointsM()[k]});
    return found;
}

std::vector<Track> tracksWithHeights(const StreetGraph& graph, std::size_t tracks,
                                     const std::vector<CentreLine>& lines,
                                     const std::vector<glm::dvec2>& places, const StreetHeights& heights,
                                     const std::vector<TrackSpan>& spans, const GroundHeight& ground)
{
    TrackCutter cutter(graph, lines, places, heights, spans, ground);
    for (std::size_t i = tracks; i < graph.chains.size(); ++i)
        cutter.cut(i);
    return std::move(cutter.tracks);
}

} // namespace worldmaking
