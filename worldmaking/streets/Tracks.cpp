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

#include "worldmaking/map/PlaceKey.h"
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

constexpr std::array<TrackClass, 6> kTrackClasses{{{"rail", 0.04},
                                                   {"preserved", 0.04},
                                                   {"light_rail", 0.06},
                                                   {"subway", 0.05},
                                                   {"narrow_gauge", 0.07},
                                                   {"tram", 0.12}}};
constexpr double kMainLine = 0.025;

/// A place along a chain, before chains are cut.
struct TrackPlace
{
    glm::dvec2 place{0.0};
    double alongM = 0.0, heightM = 0.0;
    std::optional<double> streetM; ///< of the street whose lanes the rails lie in
};

/// Cuts one chain of railways into stretches.
class TrackCutter
{
public:
    explicit TrackCutter(const TrackSources& from) : _from(from) {}

    void cut(std::size_t index)
    {
        const StreetChain& chain = _from.graph.chains[index];
        const auto& pointsM = _from.lines[index].pointsM();
        std::vector<TrackPlace> places;
        std::vector<std::size_t> pieces; // of each step
        for (std::size_t piece = 0; piece < chain.pieces.size(); ++piece)
        {
            const glm::dvec2 from = _from.places[chain.points[piece]],
                             to = _from.places[chain.points[piece + 1]];
            const double lengthM = glm::distance(from, to);
            if (lengthM < 1e-6) continue;
            const int steps = std::max(1, static_cast<int>(std::ceil(lengthM / kTrackStepM)));
            for (int step = places.empty() ? 0 : 1; step <= steps; ++step)
            {
                const double share = static_cast<double>(step) / steps;
                places.push_back({glm::mix(from, to, share),
                                  std::lerp(pointsM[piece], pointsM[piece + 1], share), 0.0, std::nullopt});
                if (places.size() > 1) pieces.push_back(piece);
            }
        }
        if (places.size() < 2) return;
        setHeights(index, pieces, places);
        _isOpen = false;
        const std::size_t first = tracks.size();
        for (std::size_t i = 0; i + 1 < places.size(); ++i)
            addStep(index, pieces[i], places[i], places[i + 1]);
        if (tracks[first].place == StreetPlace::tunnel)
            tracks[first].isPortalAtStart = isPortalAt({index, false});
        if (tracks.back().place == StreetPlace::tunnel)
            tracks.back().isPortalAtEnd = isPortalAt({index, true});
    }

    std::vector<Track> tracks;

private:
    StreetPlace placeAt(std::size_t index, std::size_t piece, double alongM) const
    {
        for (const TrackSpan& span : _from.spans)
            if (span.chain == index && alongM >= span.fromM && alongM <= span.toM) return StreetPlace::bridge;
        return _from.graph.traitsAt(_from.graph.chains[index], piece).place;
    }

    StreetPlace placeAtEnd(const StreetArm& arm) const
    {
        const StreetChain& chain = _from.graph.chains[arm.chain];
        const double alongM = arm.isEnd ? _from.lines[arm.chain].lengthM() : 0.0;
        return placeAt(arm.chain, arm.isEnd ? chain.pieces.size() - 1 : 0, alongM);
    }

    /// Whether a tunnel begins at the switch at an end of a chain: another track there lies outside. The
    /// first of the tunnels that begin there has the portal.
    bool isPortalAt(const StreetArm& end) const
    {
        const StreetChain& chain = _from.graph.chains[end.chain];
        const int crossing = end.isEnd ? chain.endCrossing : chain.startCrossing;
        if (crossing < 0) return false;
        const StreetArm* firstTube = nullptr;
        bool hasOpen = false;
        for (const StreetArm& arm : _from.graph.crossings[static_cast<std::size_t>(crossing)].arms)
            if (placeAtEnd(arm) != StreetPlace::tunnel)
                hasOpen = true;
            else if (!firstTube)
                firstTube = &arm;
        return hasOpen && firstTube && firstTube->chain == end.chain && firstTube->isEnd == end.isEnd;
    }

    void setHeights(std::size_t index, const std::vector<std::size_t>& pieces,
                    std::vector<TrackPlace>& places) const
    {
        const auto& elevation = _from.heights.profiles[index].elevation;
        for (std::size_t i = 0; i < places.size(); ++i)
        {
            TrackPlace& at = places[i];
            const std::size_t piece = pieces[std::min(i, pieces.size() - 1)];
            at.heightM = elevation.value(at.alongM);
            const std::string& kind = _from.graph.traitsAt(_from.graph.chains[index], piece).kind;
            if (kind == "tram" || kind == "light_rail")
                at.streetM = _from.streetAt(at.place, placeAt(index, piece, at.alongM), at.heightM);
        }
        const std::vector<TrackPlace> own = places;
        for (std::size_t i = 0; i < places.size(); ++i)
        {
            const auto easeM =
                easedM(own, i); // a crossing near a street that the rails lie in is one with it
            places[i].heightM = own[i].streetM ? *own[i].streetM + kFlushM - kRailTopM
                                               : own[i].heightM + (easeM ? *easeM : flushM(index, own[i]));
        }
    }

    /// By how much rails leave their own height towards the streets before and behind; nothing: none is near.
    static std::optional<double> easedM(const std::vector<TrackPlace>& places, std::size_t at)
    {
        double sumM = 0.0, weights = 0.0;
        const double endM =
            std::min(places[at].alongM - places.front().alongM, places.back().alongM - places[at].alongM);
        const auto look = [&](const TrackPlace& other)
        {
            const double awayM = std::fabs(other.alongM - places[at].alongM);
            const double share = glm::smoothstep(0.0, 1.0, awayM / kEaseM);
            const double weight = (1.0 - share) * std::min(1.0, endM / kTrackStepM);
            sumM += weight * (*other.streetM + kFlushM - kRailTopM - other.heightM);
            weights += weight;
        };
        for (std::size_t i = at; i-- > 0 && places[at].alongM - places[i].alongM < kEaseM;)
            if (places[i].streetM)
            {
                look(places[i]);
                break;
            }
        for (std::size_t i = at + 1; i < places.size() && places[i].alongM - places[at].alongM < kEaseM; ++i)
            if (places[i].streetM)
            {
                look(places[i]);
                break;
            }
        return weights > 0.0 ? std::optional(sumM / std::max(1.0, weights)) : std::nullopt;
    }

    /// By how much rails come to the streets of the level crossings before and behind.
    double flushM(std::size_t index, const TrackPlace& at) const
    {
        const LevelHeight *before = nullptr, *behind = nullptr;
        for (const LevelHeight& level : _from.heights.levels)
        {
            if (level.track != index) continue;
            const LevelHeight*& nearest = level.trackM <= at.alongM ? before : behind;
            if (!nearest || std::fabs(level.trackM - at.alongM) < std::fabs(nearest->trackM - at.alongM))
                nearest = &level;
        }
        const auto riseM = [&](const LevelHeight* level)
        {
            if (!level) return 0.0;
            const double wasM = _from.heights.profiles[index].elevation.value(level->trackM);
            const double away = std::fabs(at.alongM - level->trackM) / kEaseM;
            return (level->streetM + kFlushM - kRailTopM - wasM) * (1.0 - glm::smoothstep(0.0, 1.0, away));
        };
        if (!before || !behind) return riseM(before) + riseM(behind);
        const double share = glm::smoothstep(before->trackM, behind->trackM, at.alongM);
        return std::lerp(riseM(before), riseM(behind), share);
    }

    /// Goes on with the last stretch, or begins one.
    void addStep(std::size_t index, std::size_t piece, const TrackPlace& from, const TrackPlace& to)
    {
        const auto shape = static_cast<std::size_t>(_from.graph.chains[index].pieces[piece].way);
        const StreetPlace place = placeAt(index, piece, 0.5 * (from.alongM + to.alongM));
        const bool isInStreet = from.streetM && to.streetM;
        const bool goesOn = _isOpen && tracks.back().shape == shape && tracks.back().place == place &&
                            tracks.back().isInStreet == isInStreet;
        if (!goesOn)
        {
            const bool isTube = place == StreetPlace::tunnel;
            const bool wasTube = _isOpen && tracks.back().place == StreetPlace::tunnel;
            if (wasTube && !isTube) tracks.back().isPortalAtEnd = true;
            Track track;
            track.shape = shape, track.place = place, track.isInStreet = isInStreet;
            track.isPortalAtStart = isTube && _isOpen && !wasTube;
            tracks.push_back(std::move(track));
            add(from);
        }
        _isOpen = true;
        add(to);
    }

    void add(const TrackPlace& at)
    {
        Track& track = tracks.back();
        const auto groundM = _from.ground(at.place);
        const bool isOff = groundM && std::fabs(*groundM - at.heightM) > kOffGroundM;
        track.isOffGround = track.isOffGround || (isOff && !track.isInStreet);
        track.points.push_back(at.place);
        track.heightsM.push_back(at.heightM);
    }

    const TrackSources& _from;
    bool _isOpen = false;
};

/// Finds tracks that run beside each other in tunnels.
void shareTubes(std::vector<Track>& tracks)
{
    constexpr double kOneTubeM = 6.5, kOneLevelM = 1.5;
    for (Track& track : tracks)
    {
        if (track.place != StreetPlace::tunnel || track.points.size() < 2) continue;
        const std::size_t k = (track.points.size() - 1) / 2;
        const glm::dvec2 middle = 0.5 * (track.points[k] + track.points[k + 1]),
                         along = glm::normalize(track.points[k + 1] - track.points[k]),
                         left(-along.y, along.x);
        for (const Track& other : tracks)
        {
            if (&other == &track || other.place != StreetPlace::tunnel) continue;
            for (std::size_t i = 0; i < other.points.size(); ++i)
            {
                const glm::dvec2 away = other.points[i] - middle;
                const double aside = glm::dot(away, left);
                if (std::fabs(glm::dot(away, along)) > kTrackStepM || std::fabs(aside) > kOneTubeM ||
                    std::fabs(aside) < 1.0 || std::fabs(other.heightsM[i] - track.heightsM[k]) > kOneLevelM)
                    continue;
                (aside > 0.0 ? track.isOpenLeft : track.isOpenRight) = true;
            }
        }
    }
}

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

StreetMap tracksOf(const LandMap& land, const std::vector<MapNode>& nodes,
                   const foundation::HeightOnEarth& ground)
{
    StreetMap map;
    map.nodes = nodes;
    std::map<PlaceKey, std::uint32_t> numbers;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        numbers.try_emplace(placeKeyOf({nodes[i].longitudeDeg, nodes[i].latitudeDeg}),
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
                numbers.try_emplace(placeKeyOf(place), static_cast<std::uint32_t>(map.nodes.size()));
            if (isNew) map.nodes.push_back({0, place.y, place.x});
            if (way.nodes.empty() || way.nodes.back() != found->second) way.nodes.push_back(found->second);
        }
        if (way.nodes.size() > 1) map.ways.push_back(std::move(way));
    }
    return map;
}

void openShortTunnels(StreetGraph& tracks, const std::vector<glm::dvec2>& places,
                      const foundation::HeightInPlan& ground)
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

std::vector<Track> tracksWithHeights(const TrackSources& from)
{
    TrackCutter cutter(from);
    for (std::size_t i = from.tracks; i < from.graph.chains.size(); ++i)
        cutter.cut(i);
    shareTubes(cutter.tracks);
    return std::move(cutter.tracks);
}

} // namespace worldmaking
