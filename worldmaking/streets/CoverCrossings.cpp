// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/CoverCrossings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "worldmaking/streets/LaneLayout.h"

namespace worldmaking
{

namespace
{

using osgRoads::core::Road;
using osgRoads::core::RoadStructure;
using RoadStructureKind = osgRoads::core::StructureKind;

constexpr double kTrackHalfM = 2.5,
                 kAbutmentBesideM = 1.0; ///< of a formation; between an abutment and what it spans
constexpr double kAbutmentWallM = 0.9,
                 kFaceSlope = 0.5; ///< that a wall holds; of the ground before an abutment
constexpr double kSharpestSine = 0.3;
constexpr double kLeastCoverM = 2.0;
constexpr double kLeastFallM = 1.5; ///< of what passes over something on a bridge

/// Heights of chains along their centre lines.
struct HeightAlong
{
    const std::vector<ChainCut>& cuts;
    const StreetHeights& heights;

    double at(std::size_t chain, double alongM) const
    {
        return heights.profiles[chain].elevation.value(std::max(0.0, alongM - cuts[chain].startM));
    }
};

double halfOf(const StreetGraph& graph, std::size_t chain)
{
    const StreetTraits& traits = graph.traitsAt(graph.chains[chain], 0);
    return traits.isTrack ? kTrackHalfM : layoutOf(traits).halfWidthM();
}

/// How far a bridge reaches to either side of the middle of what it spans. `halfM`: of both ways.
double reachM(double ownHalfM, double lowerHalfM, double sine, double fallM)
{
    const double sharp = std::max(kSharpestSine, sine), cosine = std::sqrt(1.0 - sharp * sharp);
    const double faceM = std::max(0.0, fallM - kAbutmentWallM) / kFaceSlope;
    return (lowerHalfM + kAbutmentBesideM + faceM + ownHalfM * cosine) / sharp;
}

/// Whether a road has a structure of a kind from one place to another.
bool isCovered(const Road& road, RoadStructureKind kind, double fromM, double toM)
{
    return std::any_of(road.structures.begin(), road.structures.end(),
                       [&](const RoadStructure& structure)
                       {
                           return structure.kind == kind && structure.s <= fromM + 1e-6 &&
                                  structure.s + structure.length >= toM - 1e-6;
                       });
}

/// Makes structures reach from one place to another, or adds one. Returns whether it is new. One of another
/// kind in the way stays, and nothing is done.
bool cover(Road& road, RoadStructureKind kind, double fromM, double toM, std::size_t number)
{
    fromM = std::clamp(fromM, 0.0, road.length), toM = std::clamp(toM, 0.0, road.length);
    if (toM - fromM < std::min(kLeastCoverM, 0.9 * road.length) || isCovered(road, kind, fromM, toM))
        return false;
    const auto meets = [&](const RoadStructure& structure)
    { return structure.s < toM && structure.s + structure.length > fromM; };
    for (const RoadStructure& structure : road.structures)
        if (structure.kind != kind && meets(structure)) return false;
    RoadStructure made;
    made.kind = kind;
    made.type = kind == RoadStructureKind::bridge ? "concrete" : "standard";
    made.id = road.id + "-c" + std::to_string(number);
    bool isNew = true;
    for (const RoadStructure& structure : road.structures)
    {
        if (!meets(structure)) continue;
        if (isNew) made.id = structure.id;
        isNew = false;
        fromM = std::min(fromM, structure.s), toM = std::max(toM, structure.s + structure.length);
    }
    std::erase_if(road.structures, meets);
    made.s = fromM;
    made.length = toM - fromM;
    road.structures.push_back(std::move(made));
    std::sort(road.structures.begin(), road.structures.end(),
              [](const RoadStructure& a, const RoadStructure& b) { return a.s < b.s; });
    return isNew;
}

} // namespace

std::size_t coverCrossings(osgRoads::core::RoadNetwork& network, const StreetGraph& graph,
                           const std::vector<ChainCut>& cuts, const Crossings& crossings,
                           const StreetHeights& heights)
{
    const HeightAlong height{cuts, heights};
    std::size_t made = 0;
    const auto add = [&](std::size_t chain, RoadStructureKind kind, double alongM, double halfM)
    {
        const double sM = alongM - cuts[chain].startM;
        made += cover(network.roads[chain], kind, sM - halfM, sM + halfM, made) ? 1 : 0;
    };
    for (const Overpass& pass : crossings.overpasses)
    {
        if (pass.upper >= crossings.tracks || pass.lower < crossings.tracks) continue;
        const double fallM = height.at(pass.upper, pass.upperM) - height.at(pass.lower, pass.lowerM);
        if (fallM > kLeastFallM)
            add(pass.upper, RoadStructureKind::bridge, pass.upperM,
                reachM(halfOf(graph, pass.upper), kTrackHalfM, pass.sine, fallM));
    }
    for (std::size_t i = 0; i < crossings.crossed.size(); ++i)
    {
        const CrossedPlace& place = crossings.crossed[i];
        if (place.chain >= crossings.tracks) continue;
        const auto kind = place.isStreetAbove ? RoadStructureKind::bridge : RoadStructureKind::tunnel;
        const double sM = place.alongM - cuts[place.chain].startM;
        const bool isThere = isCovered(network.roads[place.chain], kind, sM, sM);
        const bool isLost =
            std::find(heights.lostCrossed.begin(), heights.lostCrossed.end(), i) != heights.lostCrossed.end();
        if (isThere || isLost) continue; // as long as the map has it
        const double faceM =
            place.isStreetAbove ? std::max(0.0, place.apartM - kAbutmentWallM) / kFaceSlope : 0.0;
        add(place.chain, kind, place.alongM, place.halfM + kAbutmentBesideM + faceM);
    }
    return made;
}

std::vector<TrackSpan> trackSpans(const StreetGraph& graph, const std::vector<ChainCut>& cuts,
                                  const Crossings& crossings, const StreetHeights& heights)
{
    const HeightAlong height{cuts, heights};
    std::vector<TrackSpan> spans;
    for (const Overpass& pass : crossings.overpasses)
    {
        if (pass.upper < crossings.tracks) continue;
        const double fallM = height.at(pass.upper, pass.upperM) - height.at(pass.lower, pass.lowerM);
        if (fallM <= kLeastFallM || pass.isLowerTube) continue;
        const double halfM = reachM(kTrackHalfM, halfOf(graph, pass.lower), pass.sine, fallM);
        spans.push_back({pass.upper, pass.upperM - halfM, pass.upperM + halfM});
    }
    for (const CrossedPlace& place : crossings.crossed)
        if (place.chain >= crossings.tracks && place.isStreetAbove)
        {
            const double halfM = place.halfM + kAbutmentBesideM;
            spans.push_back({place.chain, place.alongM - halfM, place.alongM + halfM});
        }
    return spans;
}

} // namespace worldmaking
