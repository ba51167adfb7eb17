// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "scenery/roads/things/Placers.h"
#include "scenery/roads/things/RoadLine.h"
#include "scenery/roads/things/StructureParts.h"
#include "scenery/roads/things/ThingPose.h"

namespace scenery::roads
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgRoads::core::RoadStructure;

constexpr double kDeckM = 1.2, kEdgeM = 0.2, kEdgeWidthM = 0.4,
                 kSideM = 0.5; ///< thickness; edges above the road; beyond the lanes
constexpr double kRailM = 1.1,
                 kRailPostEveryM = 2.0;           ///< height of the railing (German RAL-ING: 1.0 m and above)
constexpr double kLookM = 0.5, kLeastEdgeM = 1.0; ///< between places of an edge; its shortest piece
constexpr double kPierEveryM = 30.0, kPierRadiusM = 0.6, kPierClearM = 2.5; ///< clear of roads below

/// Whether another road lies under a place of this one, near enough to be in the way of a pier.
bool isOverRoad(const PlacedNetwork& placed, int road, const glm::dvec3& place)
{
    for (const auto& match : placed.locator().within(glm::dvec2(placed.toInertial(place)), kPierClearM))
        if (match.position.road != road &&
            placed.surfacePoint(match.position.road, match.position.s, match.position.t).z < place.z - kDeckM)
            return true;
    return false;
}

/// Returns a place for a pier near s, clear of the roads below, or nothing.
std::optional<double> pierAt(const PlacedNetwork& placed, int road, const RoadStructure& bridge, double s)
{
    const osgRoads::core::Road& plain = placed.road(road);
    for (double away = 0.0; away < 0.5 * kPierEveryM; away += 1.0)
        for (const double at : {s + away, s - away})
        {
            if (at < bridge.s + kPierClearM || at > bridge.s + bridge.length - kPierClearM) continue;
            const Sides sides = sidesAt(plain, at, 0.0);
            bool isClear = true;
            for (const double share : {-0.6, 0.0, 0.6})
                isClear = isClear &&
                          !isOverRoad(placed, road,
                                      placed.surfacePoint(road, at, sides.middle() + share * sides.half()));
            if (isClear) return at;
        }
    return {};
}

void addPier(const PlacedNetwork& placed, int road, const RoadStructure& bridge, double s, double depth,
             RoadThings& into)
{
    RoadLine pier = concreteLine(bridge);
    pier.body = simulation::ObstacleKind::pillar;
    pier.s = s - kPierRadiusM;
    pier.sEnd = s + kPierRadiusM;
    const Sides sides = sidesAt(placed.road(road), s, 0.0);
    pier.lineT = [middle = sides.middle()](double) { return middle; };
    pier.profileAt = [half = 0.6 * sides.half(), depth](double)
    { return boxProfile(half, -depth, -0.9 * kDeckM); };
    addRoadLine(placed, road, pier, into);
}

/// Adds piers where there is ground below, clear of other roads.
void addPiers(const PlacedNetwork& placed, int road, const RoadStructure& bridge,
              const foundation::HeightInPlan& ground, RoadThings& into)
{
    for (double along = 0.5 * kPierEveryM; along < bridge.length; along += kPierEveryM)
    {
        const auto s = pierAt(placed, road, bridge, bridge.s + along);
        if (!s) continue;
        const glm::dvec3 top = placed.surfacePoint(road, *s, sidesAt(placed.road(road), *s, 0.0).middle());
        const auto height = ground ? ground(glm::dvec2(top)) : std::nullopt;
        if (height && top.z - kDeckM - *height >= 1.5)
            addPier(placed, road, bridge, *s, top.z - *height + 1.0, into);
    }
}

/// A stretch of a road, in metres along it.
struct ClearStretch
{
    double from = 0.0, to = 0.0;
};

/// Returns where the edge of a bridge stands on no lanes of another road at its height: where ways come
/// together on a bridge, the edge of one would stand across the other.
std::vector<ClearStretch> clearOfOthers(const PlacedNetwork& placed, int road, const RoadLine& edge)
{
    const auto isClear = [&](double s)
    {
        const glm::dvec3 place = placed.surfacePoint(road, s, edge.lineT(s));
        const auto isLevel = [&](const osgRoads::core::RoadMatch& other)
        {
            const auto& at = other.position;
            return std::abs(placed.surfacePoint(at.road, at.s, at.t).z - place.z) < kDeckM;
        };
        return !placed.locator().holdsOnOther(glm::dvec2(placed.toInertial(place)), 0.5 * kEdgeWidthM, road,
                                              isLevel);
    };
    const int steps = std::max(1, static_cast<int>(std::ceil((edge.sEnd - edge.s) / kLookM)));
    std::vector<ClearStretch> clear;
    bool wasClear = false;
    for (int i = 0; i <= steps; ++i)
    {
        const double share = static_cast<double>(i) / steps;
        const double s = edge.s * (1.0 - share) + edge.sEnd * share;
        const bool isNow = isClear(s);
        if (isNow && wasClear) clear.back().to = s;
        if (isNow && !wasClear) clear.push_back({s, s});
        wasClear = isNow;
    }
    std::erase_if(clear, [](const ClearStretch& stretch) { return stretch.to - stretch.from < kLeastEdgeM; });
    return clear;
}

/// Adds the raised edge of a deck and the railing on it. `side`: 1 to the left.
void addEdge(const PlacedNetwork& placed, int road, const RoadStructure& bridge, int side, RoadThings& into)
{
    RoadLine edge = concreteLine(bridge);
    edge.lineT = [&plain = placed.road(road), side](double s)
    {
        const Sides sides = sidesAt(plain, s, kSideM);
        return side > 0 ? sides.left : sides.right;
    };
    edge.profileAt = [](double) { return boxProfile(0.5 * kEdgeWidthM, -kDeckM, kEdgeM); };
    edge.body = simulation::ObstacleKind::bridgeRail;
    edge.bodyTopM = kRailM;
    models::RoadModel post;
    post.kind = models::RoadModel::Kind::pole;
    post.widthM = 0.06;
    post.heightM = kRailM - 0.02;
    for (const ClearStretch& stretch : clearOfOthers(placed, road, edge))
    {
        edge.s = stretch.from;
        edge.sEnd = stretch.to;
        addRoadLine(placed, road, edge, into);
        RoadLine bar = edge;
        bar.body.reset(); // within that of the edge
        bar.surface = models::kPlain;
        bar.uvPerM = 0.0;
        bar.tint = {0.50F, 0.52F, 0.53F};
        for (const double high : {0.45, 0.75, kRailM})
        {
            bar.profileAt = [high](double) { return boxProfile(0.025, high - 0.05, high); };
            addRoadLine(placed, road, bar, into);
        }
        for (double s = stretch.from + 0.5; s < stretch.to; s += kRailPostEveryM)
        {
            StandingThing thing;
            thing.position = placed.surfacePoint(road, s, edge.lineT(s));
            thing.axes = uprightAxes(placed, road, s, edge.lineT(s), 0.0);
            addStanding(into, post, thing);
        }
    }
}

void addBridge(const PlacedNetwork& placed, int road, const RoadStructure& bridge,
               const foundation::HeightInPlan& ground, RoadThings& into)
{
    const auto& plain = placed.road(road);
    for (const int side : {1, -1})
        if (plain.junctionId.empty()) // a railing along a turn would stand across the other lanes
            addEdge(placed, road, bridge, side, into);
    // Below the surface by 5 cm, so that the deck never fights the road for depth. The road's tilt is that of
    // its edges.
    RoadLine deck = concreteLine(bridge);
    deck.lineT = [&plain](double s) { return sidesAt(plain, s, kSideM).middle(); };
    deck.profileAt = [&placed, &plain, road](double s)
    {
        const Sides sides = sidesAt(plain, s, kSideM);
        const double tilt = 0.5 * (placed.surfacePoint(road, s, sides.left).z -
                                   placed.surfacePoint(road, s, sides.right).z),
                     half = sides.half();
        return Profile{
            {-half, -kDeckM - tilt}, {half, -kDeckM + tilt}, {half, -0.05 + tilt}, {-half, -0.05 - tilt}};
    };
    addRoadLine(placed, road, deck, into);
    addPiers(placed, road, bridge, ground, into);
}

} // namespace

void placeStructures(const PlacedNetwork& placed, int road, const foundation::HeightInPlan& ground,
                     RoadThings& into)
{
    for (const RoadStructure& structure : placed.road(road).structures)
        if (structure.kind == osgRoads::core::StructureKind::bridge)
            addBridge(placed, road, structure, ground, into);
        else if (placed.road(road).junctionId.empty()) // walls of a turn would stand across the other lanes
            placeTunnel(placed, road, structure, into);
}

RoadThings placeRoadThings(const PlacedNetwork& placed, const foundation::HeightInPlan& ground)
{
    RoadThings things;
    for (int road = 0; road < static_cast<int>(placed.network().roads.size()); ++road)
    {
        if (!placed.road(road).isUsable) continue;
        placeSignals(placed, road, things);
        placeObjects(placed, road, ground, things);
        placeStructures(placed, road, ground, things);
    }
    return things;
}

} // namespace scenery::roads
