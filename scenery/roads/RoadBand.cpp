// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/RoadBand.h"

#include <algorithm>
#include <cmath>

#include <osgRoads/core/place/TunnelTube.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace scenery
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgRoads::core::RoadMatch;

constexpr double kUndercutSamples = 2.0;  ///< a triangle's long side and some more
constexpr double kProtectedSamples = 1.2; ///< so far from lower lanes no bed lies higher
constexpr double kAbutmentShare = 0.25;   ///< of a bridge, at most

/// The band of a bed below a verge whose surface is at `surfaceM`, `outM` from the lanes.
HeightBand bandUnderVerge(double surfaceM, double outM, const RoadCutShape& shape)
{
    const double risen = std::clamp((outM - shape.bed.vergeM + shape.riseM) / shape.riseM, 0.0, 1.0);
    const double height = surfaceM - std::lerp(shape.bed.depthM, shape.vergeEndM, risen);
    return {height, height, true};
}

/// The band beside a bridge or a portal at `outM` from the lanes of a road whose verge ends at `edgeM`.
HeightBand bandBeyondVerge(double edgeM, double outM, double reachM, const RoadCutShape& shape)
{
    const double beyondM = outM - shape.bed.vergeM, leftM = reachM - outM;
    if (leftM <= 0.0) return {};
    const double halfM = shape.slope * beyondM * (1.0 + beyondM / leftM);
    return {edgeM - shape.vergeEndM - halfM, edgeM - shape.vergeEndM + halfM};
}

/// By how much the bed of a steep bank has to lie lower near an edge of the lanes: a triangle of the ground
/// that reaches from the verge up the bank would lie above both. So there the verge's own slope goes on below
/// the bank.
double undercutM(const osgRoads::core::Road& road, const osgRoads::core::RoadPosition& at,
                 const RoadCutShape& shape)
{
    if (!road.hasTilt()) return 0.0;
    const auto frame = osgRoads::core::frameAt(road, at.s);
    const auto heightAt = [&](double t)
    { return frame.pointAt(t, osgRoads::core::surfaceHeight(road, at.s, t)).z; };
    const auto lateralAt = [&](double t)
    { return frame.lateralOf(t, osgRoads::core::surfaceHeight(road, at.s, t)); };
    const auto lanes = osgRoads::core::extentAt(road, at.s);
    double deepestM = 0.0;
    for (const double edge : {lanes.rightT, lanes.leftT})
    {
        const double insideM = std::abs(lateralAt(at.t) - lateralAt(edge));
        if (insideM > kUndercutSamples * shape.sampleM) continue;
        deepestM = std::max(deepestM, heightAt(at.t) - heightAt(edge) - shape.bed.vergeFall * insideM);
    }
    return deepestM;
}

/// The ground stays below the deck of a bridge.
HeightBand bandOfBridge(double surfaceM, double outM, const RoadCutShape& shape)
{
    HeightBand band;
    band.highM = surfaceM - shape.deckM;
    if (outM > shape.bed.vergeM)
        band.highM = bandBeyondVerge(band.highM, outM, shape.structureM, shape).highM;
    return band;
}

/// Behind a portal the bands of the open road become wider with the depth, until no ground is outside of
/// them.
HeightBand bandOfTunnel(double depthM, double surfaceM, double outM, const RoadCutShape& shape)
{
    const double behindM = std::max(depthM - std::max(shape.portalBackM, 1.5 * shape.sampleM), 0.0);
    const bool isVerge = outM <= shape.bed.vergeM;
    const HeightBand open = isVerge ? bandUnderVerge(surfaceM, outM, shape)
                                    : bandBeyondVerge(surfaceM, outM, shape.reachM, shape);
    if (open.isOpen()) return {};
    const double middleM = 0.5 * (open.lowM + open.highM);
    const double halfM = std::hypot(0.5 * (open.highM - open.lowM), shape.portalSlope * behindM);
    return {middleM - halfM, middleM + halfM};
}

/// Returns the surface of a road where it is nearest, in the samples' datum.
double surfaceM(const PlacedNetwork& roads, const RoadMatch& match,
                const osgTerrainROAM::core::TileFrame& frame, const RoadCutShape& shape)
{
    return frame.heightOf(roads.surfaceAt(match, shape.bed, shape.bed.vergeM));
}

/// The band that a bridge or a tunnel asks for.
HeightBand bandOfStructure(const PlacedNetwork& roads, const RoadMatch& match,
                           const osgRoads::core::RoadStructure& structure,
                           const osgTerrainROAM::core::TileFrame& frame, const RoadCutShape& shape)
{
    const double heightM = surfaceM(roads, match, frame, shape);
    if (structure.kind == osgRoads::core::StructureKind::bridge)
        return bandOfBridge(heightM, match.distance, shape);
    const double depthM =
        osgRoads::core::depthInTunnel(roads.road(match.position.road), structure, match.position.s);
    return bandOfTunnel(depthM, heightM, match.distance, shape);
}

/// The bed that an open road asks for, up to a sample beyond its verge, too. A sample beyond its end the
/// ground is as beside the verge: a triangle that rises from there to a hill would lie over its lanes.
HeightBand bedOf(const PlacedNetwork& roads, const RoadMatch& match,
                 const osgTerrainROAM::core::TileFrame& frame, const RoadCutShape& shape)
{
    const auto& position = match.position;
    const auto& road = roads.road(position.road);
    const double heightM = surfaceM(roads, match, frame, shape);
    if (match.distance < 1e-6) return bandUnderVerge(heightM - undercutM(road, position, shape), 0.0, shape);
    const auto lanes = osgRoads::core::extentAt(road, position.s);
    const bool isBeyondEnd = position.t >= lanes.rightT && position.t <= lanes.leftT;
    if (isBeyondEnd) return {heightM - shape.vergeEndM, heightM - shape.vergeEndM, true};
    HeightBand band = bandUnderVerge(heightM, std::min(match.distance, shape.bed.vergeM), shape);
    band.isBed = match.distance <= shape.bed.vergeM;
    return band;
}

/// Whether a place of a bridge lies so near to its end that the ground has to carry the road there: between a
/// sample on the road and the next one under the bridge the ground falls, and must not do so before the
/// bridge begins.
bool isOnAbutment(const osgRoads::core::Road& road, const osgRoads::core::RoadStructure& structure, double s,
                  const RoadCutShape& shape)
{
    if (structure.kind != osgRoads::core::StructureKind::bridge) return false;
    const double reachM = std::min(shape.abutmentSamples * shape.sampleM, kAbutmentShare * structure.length);
    const double beforeM = s - structure.s, afterM = structure.s + structure.length - s;
    const auto isOpen = [&](double at)
    { return at > 0.0 && at < road.length && !osgRoads::core::structureAt(road, at); };
    return (beforeM < reachM && isOpen(structure.s - shape.sampleM)) ||
           (afterM < reachM && isOpen(structure.s + structure.length + shape.sampleM));
}

} // namespace

HeightBand roadBand(const PlacedNetwork& roads, const osgTerrainROAM::core::TileFrame& frame,
                    const RoadCutShape& shape, const glm::dvec3& scene, double withinM)
{
    HeightBand bed, beside;
    bed.lowM = 1e9;
    const double bedReachM = std::max(shape.bed.vergeM, kProtectedSamples * shape.sampleM);
    const glm::dvec2 plan(roads.toInertial(scene));
    for (const RoadMatch& match : roads.locator().within(plan, std::max(withinM, bedReachM)))
    {
        const auto& [index, s, t, h] = match.position;
        if (shape.torn && shape.torn->at(index, s)) continue;
        const auto* structure = osgRoads::core::structureAt(roads.road(index), s);
        if (structure && !isOnAbutment(roads.road(index), *structure, s, shape))
        {
            const HeightBand asked = bandOfStructure(roads, match, *structure, frame, shape);
            beside.lowM = std::max(beside.lowM, asked.lowM);
            beside.highM = std::min(beside.highM, asked.highM);
            continue;
        }
        if (match.distance > bedReachM) continue;
        const HeightBand asked = bedOf(roads, match, frame, shape);
        if (asked.isOpen()) continue;
        bed.lowM = bed.highM = std::min(bed.lowM, asked.lowM);
        bed.isBed = bed.isBed || asked.isBed;
    }
    return bed.isBed ? bed : beside;
}

} // namespace scenery
